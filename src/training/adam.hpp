// Adam with a state that can be saved, and the order of an epoch's faces.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "training/torch_network.hpp"

namespace mien::training {

// Streams of chance, apart from each other and from those of the initial weights.
constexpr std::uint64_t kOrderStream = 0x6f72646572, kNoiseStream = 0x6e6f697365,
                        kDropStream = 0x64726f70;

/// The faces of an epoch in an order of its own: sorted by a random number each.
inline std::vector<Index> order_of(std::uint64_t seed, int epoch, Index faces) {
    const CounterRandom chance(seed ^ kOrderStream, static_cast<std::uint64_t>(epoch));
    std::vector<std::pair<double, Index>> keys;
    for (Index k = 0; k < faces; ++k)
        keys.emplace_back(chance.uniform(static_cast<std::uint64_t>(k)), k);
    std::sort(keys.begin(), keys.end());
    std::vector<Index> order;
    for (const auto& key : keys) order.push_back(key.second);
    return order;
}

/// Kingma and Ba 2015, in the form of torch::optim::Adam, with a state that can be saved.
class Adam {
  public:
    explicit Adam(const std::map<std::string, Tensor>& weights) : weights_(weights) {
        for (const auto& [name, weight] : weights_) {
            first_[name] = torch::zeros_like(weight);
            second_[name] = torch::zeros_like(weight);
        }
    }
    void clear_gradients() {
        for (auto& entry : weights_)
            if (entry.second.grad().defined()) entry.second.mutable_grad().zero_();
    }
    void step(double rate, double weight_decay) {
        const torch::NoGradGuard no_gradient;
        ++steps_;
        const double fade_first = 1 - std::pow(kFirst, static_cast<double>(steps_));
        const double fade_second = 1 - std::pow(kSecond, static_cast<double>(steps_));
        for (auto& [name, weight] : weights_) {
            if (!weight.grad().defined()) continue;
            Tensor gradient = weight.grad();
            if (weight_decay != 0) gradient = gradient + weight * weight_decay;
            Tensor& first = first_[name];
            Tensor& second = second_[name];
            first.mul_(kFirst).add_(gradient, 1 - kFirst);
            second.mul_(kSecond).addcmul_(gradient, gradient, 1 - kSecond);
            const Tensor spread = (second / fade_second).sqrt_().add_(1e-8);
            weight.addcdiv_(first, spread, -rate / fade_first);
        }
    }
    std::map<std::string, Tensor>& first() { return first_; }
    std::map<std::string, Tensor>& second() { return second_; }
    std::int64_t steps() const { return steps_; }
    void set_steps(std::int64_t steps) { steps_ = steps; }

  private:
    static constexpr double kFirst = 0.9, kSecond = 0.999;
    std::map<std::string, Tensor> weights_, first_, second_;
    std::int64_t steps_ = 0;
};

}  // namespace mien::training
