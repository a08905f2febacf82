// z_i = ELU(A_i' [x_j]), y_i = act(W vec(z_i) + b) + R x_i + s: K neighbours in a fixed order,
// mixed by a matrix of each vertex' own, which may be a sum of a few bases (A_i = sum_s v_is B_s).
#include <algorithm>

#include "learning/network_step.hpp"

namespace mien {
namespace {

class PermutedStep : public NetworkStep {
  public:
    PermutedStep(const NetworkLayers& network, const NetworkLayer& layer)
        : rows_(layer.rows_out),
          rows_in_(layer.rows_in),
          in_(layer.channels_in),
          elu_(layer.elu),
          index_(network.tensor(layer, "index")),
          bias_(network.tensor(layer, "bias")),
          shortcut_bias_(network.tensor(layer, "shortcut_bias")),
          places_(static_cast<Index>(index_.shape[1])),
          panel_(panel_rows(places_ * in_)),
          padding_(static_cast<std::size_t>(in_), 0.0f) {
        if (network.has(layer, "mixing")) {
            mixing_ = network.tensor(layer, "mixing");
        } else {
            mixing_ = network.tensor(layer, "mixing_weight");
            mixing_basis_ = network.tensor(layer, "mixing_basis");
            bases_ = static_cast<Index>(mixing_.shape[1]);
        }
        weight_.pack(network.tensor(layer, "weight").floats(), places_ * in_, layer.channels_out);
        shortcut_.pack(network.tensor(layer, "shortcut").floats(), in_, layer.channels_out);
        panel_floats = static_cast<std::size_t>(panel_ * places_ * in_ + places_ * places_);
        panel_pointers = static_cast<std::size_t>(panel_ + places_);
    }

    void run(const float* in, float* out, const PanelLoop& panels) const override {
        const Index width = weight_.columns();
        panels.run(rows_, panel_, [&](Index first, Index count, PanelScratch& scratch) {
            const auto& kernels = network_kernels();
            const float** rows = scratch.pointers.data();
            for (Index r = 0; r < count; ++r)
                rows[r] = row(in, index_.numbers()[(first + r) * places_]);
            network_loops::Epilogue epilogue;
            epilogue.bias = shortcut_bias_.floats();
            kernels.product(rows, count, 1, in_, shortcut_.data(), width, epilogue,
                            out + first * width, width);
            mix_panel(in, first, count, scratch);
            epilogue.bias = bias_.floats();
            epilogue.elu = elu_;
            epilogue.accumulate = true;
            kernels.product(rows, count, 1, places_ * in_, weight_.data(), width, epilogue,
                            out + first * width, width);
        });
    }

  private:
    const float* row(const float* in, std::uint32_t number) const {
        return static_cast<Index>(number) < rows_in_ ? in + static_cast<Index>(number) * in_
                                                     : padding_.data();
    }
    void mix_panel(const float* in, Index first, Index count, PanelScratch& scratch) const {
        const Index depth = places_ * in_;
        const float** rows = scratch.pointers.data();
        const float** neighbours = rows + panel_;
        for (Index r = 0; r < count; ++r) {
            const std::uint32_t* list = index_.numbers() + (first + r) * places_;
            for (Index k = 0; k < places_; ++k) neighbours[k] = row(in, list[k]);
            float* mixed = scratch.floats.data() + r * depth;
            network_kernels().mix(neighbours, places_,
                                  matrix(first + r, scratch.floats.data() + panel_ * depth),
                                  places_, in_, mixed);
            rows[r] = mixed;
        }
        network_kernels().elu(scratch.floats.data(), count * depth);
    }
    const float* matrix(Index vertex, float* room) const {
        const Index size = places_ * places_;
        if (bases_ == 0) return mixing_.floats() + vertex * size;
        std::fill_n(room, size, 0.0f);
        for (Index s = 0; s < bases_; ++s) {
            const float factor = mixing_.floats()[vertex * bases_ + s];
            const float* basis = mixing_basis_.floats() + s * size;
            for (Index k = 0; k < size; ++k) room[k] += factor * basis[k];
        }
        return room;
    }

    Index rows_, rows_in_, in_;
    bool elu_;
    NetworkTensor index_, bias_, shortcut_bias_, mixing_, mixing_basis_;
    Index places_, panel_, bases_ = 0;
    std::vector<float> padding_;
    PackedMatrix weight_, shortcut_;
};

}  // namespace

std::unique_ptr<NetworkStep> make_permuted_step(const NetworkLayers& network,
                                                const NetworkLayer& layer) {
    return std::make_unique<PermutedStep>(network, layer);
}

}  // namespace mien
