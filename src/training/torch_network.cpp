#include "training/torch_network.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "base/random.hpp"
#include "training/steered_mix.hpp"
#include "training/trainer.hpp"

namespace mien::training {
namespace {

std::vector<int64_t> sizes_of(const NetworkTensor& tensor) {
    return std::vector<int64_t>(tensor.shape.begin(), tensor.shape.end());
}

Tensor float_tensor(const NetworkTensor& tensor, const torch::TensorOptions& floats) {
    return torch::from_blob(const_cast<float*>(tensor.floats()), sizes_of(tensor),
                            torch::TensorOptions().dtype(torch::kFloat32))
        .to(floats.device(), c10::typeMetaToScalarType(floats.dtype()), false, true);
}

Tensor index_tensor(const std::vector<int64_t>& values, const torch::Device& device) {
    return torch::tensor(values, torch::TensorOptions().dtype(torch::kInt64)).to(device);
}

std::vector<int64_t> numbers_of(const NetworkTensor& tensor) {
    return std::vector<int64_t>(tensor.numbers(), tensor.numbers() + tensor.count());
}

}  // namespace

TorchLayer::TorchLayer(const NetworkLayers& network, const NetworkLayer& layer,
                       const std::map<std::string, Tensor>& weights,
                       const torch::TensorOptions& floats)
    : layer_(layer), floats_(floats) {
    for (const auto& [role, name] : layer.tensors)
        if (weights.count(name) != 0) weights_[role] = weights.at(name);
    if (network.has(layer, "begin")) pad_rows(network);
    if (network.has(layer, "index")) {
        const NetworkTensor& list = network.tensor(layer, "index");
        const std::vector<int64_t> numbers = numbers_of(list);
        places_ = list.shape.size() > 1 ? static_cast<int64_t>(list.shape[1]) : 1;
        padded_ = *std::max_element(numbers.begin(), numbers.end()) == layer.rows_in;
        index_ = index_tensor(numbers, floats.device());
        std::vector<int64_t> first;
        for (std::size_t k = 0; k < numbers.size(); k += static_cast<std::size_t>(places_))
            first.push_back(numbers[k]);
        centre_ = index_tensor(first, floats.device());
    }
    if (network.has(layer, "centre"))
        centre_ = index_tensor(numbers_of(network.tensor(layer, "centre")), floats.device());
}

void TorchLayer::pad_rows(const NetworkLayers& network) {
    const std::vector<int64_t> begin = numbers_of(network.tensor(layer_, "begin"));
    const std::vector<int64_t> neighbour = numbers_of(network.tensor(layer_, "neighbour"));
    for (Index i = 0; i < layer_.rows_out; ++i)
        places_ = std::max(
            places_, begin[static_cast<std::size_t>(i) + 1] - begin[static_cast<std::size_t>(i)]);
    const auto total = static_cast<int64_t>(neighbour.size());
    std::vector<int64_t> index, entry, entries;
    std::vector<float> mask;
    for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
        entries.push_back(begin[i + 1] - begin[i]);
        for (int64_t k = 0; k < places_; ++k) {
            const int64_t e = begin[i] + k;
            const bool there = e < begin[i + 1];
            index.push_back(there ? neighbour[static_cast<std::size_t>(e)] : 0);
            entry.push_back(there ? e : total);
            mask.push_back(there ? 1.0f : 0.0f);
        }
    }
    index_ = index_tensor(index, floats_.device());
    entry_ = index_tensor(entry, floats_.device());
    entries_ = index_tensor(entries, floats_.device());
    mask_ = torch::tensor(mask)
                .to(floats_.device(), c10::typeMetaToScalarType(floats_.dtype()))
                .view({layer_.rows_out, places_});
}

/// The rows of every list: [batch, rows_out, places, channels].
Tensor TorchLayer::rows_of(const Tensor& x) const {
    Tensor from = x;
    if (padded_) from = torch::cat({x, torch::zeros({x.size(0), 1, x.size(2)}, floats_)}, 1);
    return from.index_select(1, index_).view({x.size(0), layer_.rows_out, places_, x.size(2)});
}

Tensor TorchLayer::gather(const Tensor& x) const {
    const Tensor rows = rows_of(x).view({x.size(0), layer_.rows_out, places_ * x.size(2)});
    return act(torch::matmul(rows, weight("weight")) + weight("bias"));
}

Tensor TorchLayer::steered(const Tensor& x) const {
    const Tensor& offset = weight("offset");
    const int64_t batch = x.size(0), rows = layer_.rows_out, matrices = offset.size(0);
    const Tensor p = torch::matmul(x, weight("steer"));
    const Tensor p_centre = p.index_select(1, centre_).view({batch, rows, 1, matrices});
    const Tensor share = mask_ / mask_.sum(1, true);
    const Tensor q =
        torch::softmax(rows_of(p) - p_centre + offset, -1) * share.view({1, rows, places_, 1});
    const Tensor mixed = steered_mix(q, x, index_, entries_);
    return act(torch::matmul(mixed, weight("weight")) + weight("bias"));
}

Tensor TorchLayer::basis(const Tensor& x) const {
    const int64_t batch = x.size(0), rows = layer_.rows_out, in = x.size(2);
    const Tensor& coefficient = weight("coefficient");
    const int64_t bases = coefficient.size(1);
    // Entries of one row side by side, zeros for padding; the batch stands last, so that one small
    // matrix per row serves all faces.
    const Tensor a = torch::cat({coefficient, torch::zeros({1, bases}, floats_)}, 0)
                         .index_select(0, entry_)
                         .view({rows, places_, bases});
    const Tensor columns = x.permute({1, 2, 0})
                               .reshape({x.size(1), in * batch})
                               .index_select(0, index_)
                               .view({rows, places_, in * batch});
    const Tensor slots =
        torch::bmm(a.transpose(1, 2), columns).view({rows, bases * in, batch}).permute({2, 0, 1});
    Tensor y = act(torch::matmul(slots, weight("weight")) + weight("bias")) *
               std::sqrt(1 - layer_.residual_rate);
    if (layer_.residual_rate == 0) return y;
    Tensor mean = x;
    if (has("density")) {
        const Tensor density = torch::cat({weight("density").abs(), torch::zeros({1}, floats_)}, 0)
                                   .index_select(0, entry_)
                                   .view({rows, 1, places_});
        const Tensor share = density / density.sum(2, true).clamp_min(1e-12);
        mean = torch::bmm(share, columns).view({rows, in, batch}).permute({2, 0, 1});
    }
    if (has("shortcut")) mean = torch::matmul(mean, weight("shortcut"));
    return y + mean * std::sqrt(layer_.residual_rate);
}

Tensor TorchLayer::permuted(const Tensor& x) const {
    const int64_t batch = x.size(0), rows = layer_.rows_out, in = x.size(2);
    const Tensor mixing = has("mixing")
                              ? weight("mixing")
                              : torch::matmul(weight("mixing_weight"),
                                              weight("mixing_basis").view({-1, places_ * places_}))
                                    .view({rows, places_, places_});
    Tensor from = x;
    if (padded_) from = torch::cat({x, torch::zeros({batch, 1, in}, floats_)}, 1);
    const Tensor columns = from.permute({1, 2, 0})
                               .reshape({from.size(1), in * batch})
                               .index_select(0, index_)
                               .view({rows, places_, in * batch});
    const Tensor mixed = torch::elu(torch::bmm(mixing.transpose(1, 2), columns))
                             .view({rows, places_ * in, batch})
                             .permute({2, 0, 1});
    const Tensor shortcut =
        torch::matmul(from.index_select(1, centre_), weight("shortcut")) + weight("shortcut_bias");
    return act(torch::matmul(mixed, weight("weight")) + weight("bias")) + shortcut;
}

Tensor TorchLayer::run(const Tensor& x) const {
    const int64_t batch = x.size(0);
    switch (layer_.kind) {
        case LayerKind::gather:
            return gather(x);
        case LayerKind::steered:
            return steered(x);
        case LayerKind::basis:
            return basis(x);
        case LayerKind::permuted:
            return permuted(x);
        case LayerKind::dense:
            return act(torch::matmul(x.reshape({batch, -1}), weight("weight")) + weight("bias"))
                .view({batch, layer_.rows_out, layer_.channels_out});
        case LayerKind::pick:
            return x.index_select(1, index_);
        case LayerKind::sparse: {
            const Tensor value = torch::cat({weight("value"), torch::zeros({1}, floats_)}, 0)
                                     .index_select(0, entry_)
                                     .view({1, layer_.rows_out, places_, 1});
            return (rows_of(x) * value).sum(2);
        }
        case LayerKind::elu:
            return torch::elu(x);
        case LayerKind::affine:
            return x * weight("scale") + weight("shift");
    }
    fail(Status::internal, "a layer kind without a training form");
}

TorchNetwork::TorchNetwork(const NetworkLayers& network, torch::Dtype dtype, torch::Device device) {
    const auto floats = torch::TensorOptions().dtype(dtype).device(device);
    for (const auto* list : {&network.encoder, &network.decoder, &network.variance})
        for (const NetworkLayer& layer : *list)
            for (const auto& [role, name] : layer.tensors) {
                const NetworkTensor& tensor = network.tensors.at(name);
                if (tensor.dtype != DType::f32 || all_.count(name) != 0) continue;
                all_[name] = float_tensor(tensor, floats);
                if (!is_trained_role(layer.kind, role)) continue;
                all_[name].requires_grad_(true);
                weights_[name] = all_[name];
            }
    for (const NetworkLayer& layer : network.encoder)
        encoder_.emplace_back(network, layer, all_, floats);
    for (const NetworkLayer& layer : network.decoder)
        decoder_.emplace_back(network, layer, all_, floats);
    for (const NetworkLayer& layer : network.variance)
        variance_.emplace_back(network, layer, all_, floats);
}

TorchNetwork::Code TorchNetwork::encode(const Tensor& x) const {
    Code code;
    Tensor y = x;
    for (std::size_t k = 0; k < encoder_.size(); ++k) {
        if (k + 1 == encoder_.size() && !variance_.empty()) {
            code.log_variance = y;
            for (const TorchLayer& layer : variance_)
                code.log_variance = layer.run(code.log_variance);
        }
        y = encoder_[k].run(y);
    }
    code.mean = y;
    return code;
}

Tensor TorchNetwork::decode(const Tensor& code) const {
    Tensor y = code;
    for (const TorchLayer& layer : decoder_) y = layer.run(y);
    return y;
}

void TorchNetwork::read_from(const NetworkLayers& network) {
    const torch::NoGradGuard no_gradient;
    for (auto& [name, weight] : weights_)
        weight.copy_(float_tensor(network.tensors.at(name), weight.options()));
}

void TorchNetwork::write_to(NetworkLayers& network) const {
    for (const auto& [name, weight] : weights_) {
        const Tensor flat = weight.detach().to(torch::kCPU, torch::kFloat32).contiguous();
        const float* data = flat.data_ptr<float>();
        network.tensors[name] = make_tensor(network.tensors.at(name).shape,
                                            std::vector<float>(data, data + flat.numel()));
    }
}

double gradient_error(const NetworkLayers& network, uint64_t seed, int samples) {
    TorchNetwork model(network, torch::kFloat64, torch::kCPU);
    const NetworkLayer& first = network.encoder.front();
    const CounterRandom chance(seed, 77);
    uint64_t next = 0;
    const auto random = [&](std::vector<int64_t> sizes) {
        Tensor tensor = torch::empty(sizes, torch::kFloat64);
        auto* data = tensor.data_ptr<double>();
        for (int64_t k = 0; k < tensor.numel(); ++k) data[k] = chance.normal(next++);
        return tensor;
    };
    Tensor x = random({2, first.rows_in, first.channels_in}).requires_grad_(true);
    const Tensor direction =
        random({2, network.encoder.back().rows_out, network.encoder.back().channels_out});
    const auto loss = [&] { return (model.encode(x).mean * direction).sum(); };
    loss().backward();
    std::map<std::string, Tensor> leaves = model.weights();
    leaves["the input"] = x;
    double worst = 0;
    const torch::NoGradGuard no_gradient;
    for (auto& [name, leaf] : leaves) {
        const Tensor gradient =  // none: the layer does not look at this tensor
            (leaf.grad().defined() ? leaf.grad() : torch::zeros_like(leaf)).contiguous().view(-1);
        const double size = std::max(gradient.abs().max().item<double>(), 1e-6);
        auto* data = leaf.data_ptr<double>();
        for (int k = 0; k < samples; ++k) {
            const auto place = static_cast<int64_t>(chance.uniform(next++) *
                                                    static_cast<double>(gradient.numel()));
            const double value = data[place], step = 1e-5 * std::max(1.0, std::fabs(value));
            data[place] = value + step;
            const double above = loss().item<double>();
            data[place] = value - step;
            const double below = loss().item<double>();
            data[place] = value;
            const double difference = (above - below) / (2 * step);
            worst = std::max(worst, std::fabs(difference - gradient[place].item<double>()) / size);
        }
    }
    return worst;
}

}  // namespace mien::training
