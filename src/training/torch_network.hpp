// The layers of learning/network_layers.hpp in libtorch, with gradients: the same list, the same
// tensors, so that what is trained here is what the evaluator runs. Builds against libtorch 1.13
// and 2.x, with C++17.
#pragma once

#include <torch/torch.h>
#include <map>
#include <string>
#include <vector>

#include "learning/network_layers.hpp"

namespace mien::training {

using Tensor = torch::Tensor;

/// One layer with its lists as index tensors. Weights are shared with the network's.
class TorchLayer {
  public:
    TorchLayer(const NetworkLayers& network, const NetworkLayer& layer,
               const std::map<std::string, Tensor>& weights, const torch::TensorOptions& floats);
    /// [batch, rows_in, channels_in] -> [batch, rows_out, channels_out].
    Tensor run(const Tensor& x) const;

  private:
    void pad_rows(const NetworkLayers& network);
    Tensor rows_of(const Tensor& x) const;
    Tensor gather(const Tensor& x) const;
    Tensor steered(const Tensor& x) const;
    Tensor basis(const Tensor& x) const;
    Tensor permuted(const Tensor& x) const;
    Tensor act(const Tensor& x) const { return layer_.elu ? torch::elu(x) : x; }
    const Tensor& weight(const char* role) const { return weights_.at(role); }
    bool has(const char* role) const { return weights_.count(role) != 0; }

    NetworkLayer layer_;
    torch::TensorOptions floats_;
    std::map<std::string, Tensor> weights_;  ///< by role; constants too
    Tensor index_;    ///< rows_out * places, of the input's rows; rows_in: zeros
    Tensor entry_;    ///< the same, of the lists' entries; the number of entries: padding
    Tensor entries_;  ///< rows_out: how many of its places hold an entry
    Tensor mask_;     ///< [rows_out, places]: 1 for an entry, 0 for padding
    Tensor centre_;   ///< rows_out
    int64_t places_ = 0;
    bool padded_ = false;  ///< index_ names the row of zeros
};

class TorchNetwork {
  public:
    TorchNetwork(const NetworkLayers& network, torch::Dtype dtype, torch::Device device);

    struct Code {
        Tensor mean, log_variance;  ///< the second is undefined for a deterministic network
    };
    Code encode(const Tensor& x) const;
    Tensor decode(const Tensor& code) const;

    /// What training changes, by name: leaves that require gradients.
    const std::map<std::string, Tensor>& weights() const { return weights_; }
    /// Copies the weights of a network with the same tensors in.
    void read_from(const NetworkLayers& network);
    /// Replaces the weights in a network by the present ones, as float32.
    void write_to(NetworkLayers& network) const;

  private:
    std::map<std::string, Tensor> weights_;
    std::vector<TorchLayer> encoder_, decoder_, variance_;
    std::map<std::string, Tensor> all_;
};

}  // namespace mien::training
