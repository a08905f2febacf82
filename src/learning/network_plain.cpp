// The layers without an operator of their own: dense, pick, sparse rows, ELU, affine.
#include <algorithm>

#include "learning/network_step.hpp"

namespace mien {
namespace {

constexpr Index kPanel = 512;  // rows

class DenseStep : public NetworkStep {
  public:
    DenseStep(const NetworkLayers& network, const NetworkLayer& layer)
        : depth_(layer.rows_in * layer.channels_in),
          elu_(layer.elu),
          bias_(network.tensor(layer, "bias")) {
        weight_.pack(network.tensor(layer, "weight").floats(), depth_,
                     layer.rows_out * layer.channels_out);
    }
    void run(const float* in, float* out, const PanelLoop&) const override {
        network_loops::Epilogue epilogue;
        epilogue.bias = bias_.floats();
        epilogue.elu = elu_;
        network_kernels().product(&in, 1, 1, depth_, weight_.data(), weight_.columns(), epilogue,
                                  out, weight_.columns());
    }

  private:
    Index depth_;
    bool elu_;
    NetworkTensor bias_;
    PackedMatrix weight_;
};

class PickStep : public NetworkStep {
  public:
    PickStep(const NetworkLayers& network, const NetworkLayer& layer)
        : rows_(layer.rows_out),
          width_(layer.channels_out),
          index_(network.tensor(layer, "index")) {}
    void run(const float* in, float* out, const PanelLoop& panels) const override {
        panels.run(rows_, kPanel, [&](Index first, Index count, PanelScratch&) {
            for (Index i = first; i < first + count; ++i)
                std::copy_n(in + static_cast<Index>(index_.numbers()[i]) * width_, width_,
                            out + i * width_);
        });
    }

  private:
    Index rows_, width_;
    NetworkTensor index_;
};

class SparseStep : public NetworkStep {
  public:
    SparseStep(const NetworkLayers& network, const NetworkLayer& layer)
        : rows_(layer.rows_out),
          width_(layer.channels_out),
          begin_(network.tensor(layer, "begin")),
          neighbour_(network.tensor(layer, "neighbour")),
          value_(network.tensor(layer, "value")) {
        for (Index i = 0; i < rows_; ++i)
            panel_pointers = std::max<std::size_t>(panel_pointers,
                                                   begin_.numbers()[i + 1] - begin_.numbers()[i]);
    }
    void run(const float* in, float* out, const PanelLoop& panels) const override {
        panels.run(rows_, kPanel, [&](Index first, Index count, PanelScratch& scratch) {
            for (Index i = first; i < first + count; ++i) {
                const std::uint32_t begin = begin_.numbers()[i], end = begin_.numbers()[i + 1];
                for (std::uint32_t e = begin; e < end; ++e)
                    scratch.pointers[e - begin] =
                        in + static_cast<Index>(neighbour_.numbers()[e]) * width_;
                network_kernels().mix(scratch.pointers.data(), static_cast<Index>(end - begin),
                                      value_.floats() + begin, 1, width_, out + i * width_);
            }
        });
    }

  private:
    Index rows_, width_;
    NetworkTensor begin_, neighbour_, value_;
};

class EluStep : public NetworkStep {
  public:
    explicit EluStep(const NetworkLayer& layer)
        : rows_(layer.rows_out), width_(layer.channels_out) {}
    void run(const float* in, float* out, const PanelLoop& panels) const override {
        panels.run(rows_, kPanel, [&](Index first, Index count, PanelScratch&) {
            std::copy_n(in + first * width_, count * width_, out + first * width_);
            network_kernels().elu(out + first * width_, count * width_);
        });
    }

  private:
    Index rows_, width_;
};

class AffineStep : public NetworkStep {
  public:
    AffineStep(const NetworkLayers& network, const NetworkLayer& layer)
        : rows_(layer.rows_out),
          width_(layer.channels_out),
          scale_(network.tensor(layer, "scale")),
          shift_(network.tensor(layer, "shift")),
          stride_(scale_.shape[0] == 1 ? 0 : width_) {}
    void run(const float* in, float* out, const PanelLoop& panels) const override {
        panels.run(rows_, kPanel, [&](Index first, Index count, PanelScratch&) {
            for (Index i = first; i < first + count; ++i)
                for (Index k = 0; k < width_; ++k)
                    out[i * width_ + k] = scale_.floats()[i * stride_ + k] * in[i * width_ + k] +
                                          shift_.floats()[i * stride_ + k];
        });
    }

  private:
    Index rows_, width_;
    NetworkTensor scale_, shift_;
    Index stride_;
};

}  // namespace

std::unique_ptr<NetworkStep> make_dense_step(const NetworkLayers& network,
                                             const NetworkLayer& layer) {
    return std::make_unique<DenseStep>(network, layer);
}
std::unique_ptr<NetworkStep> make_pick_step(const NetworkLayers& network,
                                            const NetworkLayer& layer) {
    return std::make_unique<PickStep>(network, layer);
}
std::unique_ptr<NetworkStep> make_sparse_step(const NetworkLayers& network,
                                              const NetworkLayer& layer) {
    return std::make_unique<SparseStep>(network, layer);
}
std::unique_ptr<NetworkStep> make_elu_step(const NetworkLayers&, const NetworkLayer& layer) {
    return std::make_unique<EluStep>(layer);
}
std::unique_ptr<NetworkStep> make_affine_step(const NetworkLayers& network,
                                              const NetworkLayer& layer) {
    return std::make_unique<AffineStep>(network, layer);
}

}  // namespace mien
