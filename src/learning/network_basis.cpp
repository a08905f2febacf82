// y_i = sqrt(1 - rate) act(b + sum_j sum_k a_jk G_k x_j) + sqrt(rate) C sum_j rho_j x_j.
//
// Forming the kernels sum_k a_jk G_k costs B I O products an entry and is never the best order. Two
// orders are left, chosen by their counts: contract the features into the B slots of a row first
// (t_k = sum_j a_jk x_j, one product with all G), or project every input row by all G first
// (u_jk = G_k x_j) and sum over the entries, which is cheaper where few rows go to many.
#include <algorithm>
#include <cmath>

#include "learning/network_step.hpp"

namespace mien {
namespace {

class BasisStep : public NetworkStep {
  public:
    BasisStep(const NetworkLayers& network, const NetworkLayer& layer)
        : rows_(layer.rows_out),
          rows_in_(layer.rows_in),
          in_(layer.channels_in),
          out_(layer.channels_out),
          begin_(network.tensor(layer, "begin")),
          neighbour_(network.tensor(layer, "neighbour")),
          coefficient_(network.tensor(layer, "coefficient")),
          bias_(network.tensor(layer, "bias")),
          bases_(static_cast<Index>(coefficient_.shape[1])),
          padded_out_((out_ + network_loops::kWidth - 1) / network_loops::kWidth *
                      network_loops::kWidth) {
        own_.elu = layer.elu;
        own_.scale = static_cast<float>(std::sqrt(1 - layer.residual_rate));
        residual_ = layer.residual_rate > 0;
        own_.accumulate = residual_;
        residual_scale_ = static_cast<float>(std::sqrt(layer.residual_rate));
        if (network.has(layer, "density")) normalise(network.tensor(layer, "density"));
        if (network.has(layer, "shortcut"))
            shortcut_.pack(network.tensor(layer, "shortcut").floats(), in_, out_);
        const float* weight = network.tensor(layer, "weight").floats();
        choose_order();
        if (project_)
            pack_projection(weight);
        else
            weight_.pack(weight, bases_ * in_, out_);
        panel_ = panel_rows(project_ ? std::max(in_, padded_out_) : bases_ * in_);
        for (Index i = 0; i < rows_; ++i)
            degree_ = std::max<Index>(degree_, begin_.numbers()[i + 1] - begin_.numbers()[i]);
        const Index row = std::max(in_, project_ ? padded_out_ : bases_ * in_);
        panel_floats = static_cast<std::size_t>(panel_ * row);
        panel_pointers = static_cast<std::size_t>(panel_ + degree_);
        if (project_) shared_floats = static_cast<std::size_t>(rows_in_ * bases_ * padded_out_);
    }

    void run(const float* in, float* out, const PanelLoop& panels) const override {
        if (project_) project_inputs(in, panels.shared(), panels);
        panels.run(rows_, panel_, [&](Index first, Index count, PanelScratch& scratch) {
            if (residual_) residual_panel(in, out, first, count, scratch);
            if (project_)
                sum_panel(panels.shared(), out, first, count, scratch);
            else
                contract_panel(in, out, first, count, scratch);
        });
    }

  private:
    void normalise(const NetworkTensor& density) {
        share_.assign(density.floats(), density.floats() + density.count());
        for (Index i = 0; i < rows_; ++i) {
            const std::uint32_t first = begin_.numbers()[i], last = begin_.numbers()[i + 1];
            float sum = 0;
            for (std::uint32_t e = first; e < last; ++e) sum += std::fabs(share_[e]);
            // All densities zero: no residual, as in the trainer.
            const float factor = 1.0f / std::max(sum, 1e-12f);
            for (std::uint32_t e = first; e < last; ++e) share_[e] = std::fabs(share_[e]) * factor;
        }
    }
    void choose_order() {
        const auto entries = static_cast<double>(coefficient_.shape[0]);
        const auto i = static_cast<double>(in_), o = static_cast<double>(padded_out_),
                   b = static_cast<double>(bases_);
        const double contract = entries * b * i + static_cast<double>(rows_) * b * i * o;
        const double project = static_cast<double>(rows_in_) * i * b * o + entries * b * o;
        constexpr double kMostShared = 1 << 26;  // floats that the projected rows may take
        project_ = project < contract && static_cast<double>(rows_in_) * b * o < kMostShared;
    }
    /// G (B I x O) as I x (B O'), O' being O in whole lanes.
    void pack_projection(const float* weight) {
        std::vector<float> turned(static_cast<std::size_t>(in_ * bases_ * padded_out_), 0.0f);
        for (Index b = 0; b < bases_; ++b)
            for (Index i = 0; i < in_; ++i)
                std::copy_n(weight + (b * in_ + i) * out_, out_,
                            turned.data() + (i * bases_ + b) * padded_out_);
        weight_.pack(turned.data(), in_, bases_ * padded_out_);
    }
    /// Pointers to the inputs of row i's entries; gives their number.
    Index entries_of(const float* rows, Index width, Index i, const float** to) const {
        const std::uint32_t first = begin_.numbers()[i], last = begin_.numbers()[i + 1];
        for (std::uint32_t e = first; e < last; ++e)
            to[e - first] = rows + static_cast<Index>(neighbour_.numbers()[e]) * width;
        return static_cast<Index>(last - first);
    }

    void residual_panel(const float* in, float* out, Index first, Index count,
                        PanelScratch& scratch) const {
        const float** rows = scratch.pointers.data();
        for (Index r = 0; r < count; ++r) {
            rows[r] = in + (first + r) * in_;
            if (share_.empty()) continue;
            float* mean = scratch.floats.data() + r * in_;
            const float** entries = rows + panel_;
            const Index degree = entries_of(in, in_, first + r, entries);
            network_kernels().mix(entries, degree, share_.data() + begin_.numbers()[first + r], 1,
                                  in_, mean);
            rows[r] = mean;
        }
        if (shortcut_.columns() > 0) {
            network_loops::Epilogue epilogue;
            epilogue.scale = residual_scale_;
            network_kernels().product(rows, count, 1, in_, shortcut_.data(), out_, epilogue,
                                      out + first * out_, out_);
            return;
        }
        for (Index r = 0; r < count; ++r)
            for (Index k = 0; k < out_; ++k)
                out[(first + r) * out_ + k] = residual_scale_ * rows[r][k];
    }

    void contract_panel(const float* in, float* out, Index first, Index count,
                        PanelScratch& scratch) const {
        const float** rows = scratch.pointers.data();
        const float** entries = rows + panel_;
        for (Index r = 0; r < count; ++r) {
            float* slots = scratch.floats.data() + r * bases_ * in_;
            const Index degree = entries_of(in, in_, first + r, entries);
            network_kernels().mix(
                entries, degree,
                coefficient_.floats() + static_cast<Index>(begin_.numbers()[first + r]) * bases_,
                bases_, in_, slots);
            rows[r] = slots;
        }
        network_loops::Epilogue epilogue = own_;
        epilogue.bias = bias_.floats();
        network_kernels().product(rows, count, 1, bases_ * in_, weight_.data(), out_, epilogue,
                                  out + first * out_, out_);
    }

    void project_inputs(const float* in, float* projected, const PanelLoop& panels) const {
        const Index width = bases_ * padded_out_;
        panels.run(rows_in_, panel_, [&](Index first, Index count, PanelScratch& scratch) {
            const float** rows = scratch.pointers.data();
            for (Index r = 0; r < count; ++r) rows[r] = in + (first + r) * in_;
            network_kernels().product(rows, count, 1, in_, weight_.data(), width, {},
                                      projected + first * width, width);
        });
    }
    void sum_panel(const float* projected, float* out, Index first, Index count,
                   PanelScratch& scratch) const {
        const float** entries = scratch.pointers.data();
        float* sum = scratch.floats.data();
        for (Index r = 0; r < count; ++r) {
            std::fill_n(sum, padded_out_, 0.0f);
            std::copy_n(bias_.floats(), out_, sum);
            const Index degree = entries_of(projected, bases_ * padded_out_, first + r, entries);
            network_kernels().edge_sum(
                entries, degree,
                coefficient_.floats() + static_cast<Index>(begin_.numbers()[first + r]) * bases_,
                bases_, padded_out_, sum);
            if (own_.elu) network_kernels().elu(sum, padded_out_);
            float* to = out + (first + r) * out_;
            for (Index k = 0; k < out_; ++k)
                to[k] = (own_.accumulate ? to[k] : 0.0f) + own_.scale * sum[k];
        }
    }

    Index rows_, rows_in_, in_, out_;
    NetworkTensor begin_, neighbour_, coefficient_, bias_;
    Index bases_, padded_out_, panel_ = 0, degree_ = 0;
    network_loops::Epilogue own_;  ///< of the layer's own branch, without its bias
    bool residual_ = false, project_ = false;
    float residual_scale_ = 0;
    std::vector<float> share_;  ///< rho by entry; empty: the rows stay the same
    PackedMatrix weight_, shortcut_;
};

}  // namespace

std::unique_ptr<NetworkStep> make_basis_step(const NetworkLayers& network,
                                             const NetworkLayer& layer) {
    return std::make_unique<BasisStep>(network, layer);
}

}  // namespace mien
