// Layers evaluated as their equations are written (src/learning/network_layers.hpp), in double and
// in the slowest order: what the evaluator is compared with.
#pragma once

#include <cmath>
#include <vector>

#include "learning/network_layers.hpp"

namespace mien::test {

using Numbers = std::vector<double>;

class ReferenceLayer {
  public:
    ReferenceLayer(const NetworkLayers& network, const NetworkLayer& layer)
        : network_(network), layer_(layer), in_(layer.channels_in), out_(layer.channels_out) {}

    Numbers run(const Numbers& x) const {
        Numbers y(static_cast<std::size_t>(layer_.rows_out * out_), 0.0);
        for (Index i = 0; i < layer_.rows_out; ++i) {
            const Numbers row = this->row(x, i);
            for (Index o = 0; o < out_; ++o)
                y[static_cast<std::size_t>(i * out_ + o)] = row[static_cast<std::size_t>(o)];
        }
        return y;
    }

  private:
    /// Looked up once for each place that names a role: by name it takes most of the test's time.
    const NetworkTensor& tensor(const char* role) const {
        for (const auto& [name, found] : known_)
            if (name == role) return *found;
        known_.emplace_back(role, &network_.tensor(layer_, role));
        return *known_.back().second;
    }
    double f(const char* role, Index k) const {
        return static_cast<double>(tensor(role).floats()[k]);
    }
    Index n(const char* role, Index k) const {
        return static_cast<Index>(tensor(role).numbers()[k]);
    }
    Index size(const char* role, std::size_t axis) const {
        return static_cast<Index>(tensor(role).shape[axis]);
    }
    double at(const Numbers& x, Index row, Index channel) const {
        return row == layer_.rows_in ? 0.0 : x[static_cast<std::size_t>(row * in_ + channel)];
    }
    static double elu(double x) { return x > 0 ? x : std::expm1(x); }
    double act(double x) const { return layer_.elu ? elu(x) : x; }

    Numbers row(const Numbers& x, Index i) const {
        switch (layer_.kind) {
            case LayerKind::gather:
                return gather(x, i);
            case LayerKind::steered:
                return steered(x, i);
            case LayerKind::basis:
                return basis(x, i);
            case LayerKind::permuted:
                return permuted(x, i);
            default:
                return plain(x, i);
        }
    }
    Numbers gather(const Numbers& x, Index i) const {
        Numbers y;
        for (Index o = 0; o < out_; ++o) {
            double sum = f("bias", o);
            for (Index l = 0; l < size("index", 1); ++l)
                for (Index c = 0; c < in_; ++c)
                    sum += f("weight", (l * in_ + c) * out_ + o) *
                           at(x, n("index", i * size("index", 1) + l), c);
            y.push_back(act(sum));
        }
        return y;
    }
    Numbers steered(const Numbers& x, Index i) const {
        const Index matrices = size("offset", 0), begin = n("begin", i), end = n("begin", i + 1);
        Numbers y;
        for (Index o = 0; o < out_; ++o) y.push_back(f("bias", o));
        for (Index e = begin; e < end; ++e) {
            const Index j = n("neighbour", e), centre = n("centre", i);
            Numbers q;
            double largest = -1e300, total = 0;
            for (Index m = 0; m < matrices; ++m) {
                double sum = f("offset", m);
                for (Index c = 0; c < in_; ++c)
                    sum += f("steer", c * matrices + m) * (at(x, j, c) - at(x, centre, c));
                q.push_back(sum);
                largest = std::max(largest, sum);
            }
            for (double& value : q) total += value = std::exp(value - largest);
            for (Index m = 0; m < matrices; ++m)
                for (Index c = 0; c < in_; ++c)
                    for (Index o = 0; o < out_; ++o)
                        y[static_cast<std::size_t>(o)] += q[static_cast<std::size_t>(m)] / total /
                                                          static_cast<double>(end - begin) *
                                                          f("weight", (m * in_ + c) * out_ + o) *
                                                          at(x, j, c);
        }
        for (double& value : y) value = act(value);
        return y;
    }
    Numbers basis(const Numbers& x, Index i) const {
        const Index bases = size("coefficient", 1), begin = n("begin", i), end = n("begin", i + 1);
        Numbers y, residual(static_cast<std::size_t>(out_), 0.0);
        for (Index o = 0; o < out_; ++o) y.push_back(f("bias", o));
        for (Index e = begin; e < end; ++e)
            for (Index c = 0; c < in_; ++c)
                for (Index o = 0; o < out_; ++o) {
                    double kernel = 0;
                    for (Index b = 0; b < bases; ++b)
                        kernel +=
                            f("coefficient", e * bases + b) * f("weight", (b * in_ + c) * out_ + o);
                    y[static_cast<std::size_t>(o)] += kernel * at(x, n("neighbour", e), c);
                }
        double total = 0;
        const bool density = network_.has(layer_, "density");
        for (Index e = begin; density && e < end; ++e) total += std::fabs(f("density", e));
        for (Index c = 0; c < in_; ++c) {
            double mean = density ? 0 : at(x, i, c);
            for (Index e = begin; density && e < end; ++e)
                mean += std::fabs(f("density", e)) / total * at(x, n("neighbour", e), c);
            if (!network_.has(layer_, "shortcut")) residual[static_cast<std::size_t>(c)] = mean;
            for (Index o = 0; network_.has(layer_, "shortcut") && o < out_; ++o)
                residual[static_cast<std::size_t>(o)] += f("shortcut", c * out_ + o) * mean;
        }
        for (std::size_t o = 0; o < y.size(); ++o)
            y[o] = std::sqrt(1 - layer_.residual_rate) * act(y[o]) +
                   std::sqrt(layer_.residual_rate) * residual[o];
        return y;
    }
    double mixing(Index i, Index row, Index column) const {
        const Index k = size("index", 1);
        if (network_.has(layer_, "mixing")) return f("mixing", (i * k + row) * k + column);
        double sum = 0;
        for (Index s = 0; s < size("mixing_weight", 1); ++s)
            sum += f("mixing_weight", i * size("mixing_weight", 1) + s) *
                   f("mixing_basis", (s * k + row) * k + column);
        return sum;
    }
    Numbers permuted(const Numbers& x, Index i) const {
        const Index places = size("index", 1);
        Numbers y, shortcut;
        for (Index o = 0; o < out_; ++o) {
            y.push_back(f("bias", o));
            shortcut.push_back(f("shortcut_bias", o));
        }
        for (Index c = 0; c < in_; ++c) {
            for (Index o = 0; o < out_; ++o)
                shortcut[static_cast<std::size_t>(o)] +=
                    f("shortcut", c * out_ + o) * at(x, n("index", i * places), c);
            for (Index k = 0; k < places; ++k) {
                double mixed = 0;
                for (Index j = 0; j < places; ++j)
                    mixed += mixing(i, j, k) * at(x, n("index", i * places + j), c);
                for (Index o = 0; o < out_; ++o)
                    y[static_cast<std::size_t>(o)] +=
                        f("weight", (k * in_ + c) * out_ + o) * elu(mixed);
            }
        }
        for (std::size_t o = 0; o < y.size(); ++o) y[o] = act(y[o]) + shortcut[o];
        return y;
    }
    Numbers plain(const Numbers& x, Index i) const {
        Numbers y;
        for (Index o = 0; o < out_; ++o) {
            double value = 0;
            if (layer_.kind == LayerKind::dense) {
                const Index wide = layer_.rows_out * out_, column = i * out_ + o;
                value = f("bias", column);
                for (Index k = 0; k < layer_.rows_in * in_; ++k)
                    value += f("weight", k * wide + column) * x[static_cast<std::size_t>(k)];
                value = act(value);
            } else if (layer_.kind == LayerKind::pick) {
                value = at(x, n("index", i), o);
            } else if (layer_.kind == LayerKind::sparse) {
                for (Index e = n("begin", i); e < n("begin", i + 1); ++e)
                    value += f("value", e) * at(x, n("neighbour", e), o);
            } else if (layer_.kind == LayerKind::elu) {
                value = elu(at(x, i, o));
            } else {
                const Index k = (size("scale", 0) == 1 ? 0 : i * out_) + o;
                value = f("scale", k) * at(x, i, o) + f("shift", k);
            }
            y.push_back(value);
        }
        return y;
    }

    const NetworkLayers& network_;
    const NetworkLayer& layer_;
    Index in_, out_;
    mutable std::vector<std::pair<const char*, const NetworkTensor*>> known_;
};

inline Numbers reference_run(const NetworkLayers& network, const std::vector<NetworkLayer>& layers,
                             Numbers x) {
    for (const NetworkLayer& layer : layers) x = ReferenceLayer(network, layer).run(x);
    return x;
}

}  // namespace mien::test
