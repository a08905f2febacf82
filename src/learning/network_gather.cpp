// y_i = act(W [x_S(i,1); ...; x_S(i,L)] + b). Nothing is copied together: the product reads the
// rows where they lie, by a table of pointers for each panel, and rows out of range from zeros.
#include "learning/network_step.hpp"

namespace mien {
namespace {

class GatherStep : public NetworkStep {
  public:
    GatherStep(const NetworkLayers& network, const NetworkLayer& layer)
        : rows_(layer.rows_out),
          rows_in_(layer.rows_in),
          in_(layer.channels_in),
          elu_(layer.elu),
          index_(network.tensor(layer, "index")),
          bias_(network.tensor(layer, "bias")),
          places_(static_cast<Index>(index_.shape[1])),
          panel_(panel_rows(places_ * in_)),
          padding_(static_cast<std::size_t>(in_), 0.0f) {
        weight_.pack(network.tensor(layer, "weight").floats(), places_ * in_, layer.channels_out);
        panel_pointers = static_cast<std::size_t>(panel_ * places_);
    }

    void run(const float* in, float* out, const PanelLoop& panels) const override {
        const auto& kernels = network_kernels();
        network_loops::Epilogue epilogue;
        epilogue.bias = bias_.floats();
        epilogue.elu = elu_;
        panels.run(rows_, panel_, [&](Index first, Index count, PanelScratch& scratch) {
            const std::uint32_t* list = index_.numbers() + first * places_;
            for (Index k = 0; k < count * places_; ++k) {
                const auto row = static_cast<Index>(list[k]);
                scratch.pointers[static_cast<std::size_t>(k)] =
                    row < rows_in_ ? in + row * in_ : padding_.data();
            }
            kernels.product(scratch.pointers.data(), count, places_, in_, weight_.data(),
                            weight_.columns(), epilogue, out + first * weight_.columns(),
                            weight_.columns());
        });
    }

  private:
    Index rows_, rows_in_, in_;
    bool elu_;
    NetworkTensor index_, bias_;
    Index places_, panel_;
    std::vector<float> padding_;
    PackedMatrix weight_;
};

}  // namespace

std::unique_ptr<NetworkStep> make_gather_step(const NetworkLayers& network,
                                              const NetworkLayer& layer) {
    return std::make_unique<GatherStep>(network, layer);
}

}  // namespace mien
