// y_i = act(b + sum_m W_m 1/|N| sum_j q_m(i,j) x_j), q = softmax over m of u_m (x_j - x_c) + c_m.
//
// With p_j = U' x_j the softmax is that of p_jm + (c_m - p_cm). It does not change when a number is
// added for all m, so each side is exponentiated once per vertex, shifted by its own maximum, and
// an edge costs M products instead of M exponentials. Where the two maxima are so far apart that
// all products underflow, the edge is computed in the plain way.
#include <algorithm>
#include <cmath>

#include "learning/network_step.hpp"

namespace mien {
namespace {

class SteeredStep : public NetworkStep {
  public:
    SteeredStep(const NetworkLayers& network, const NetworkLayer& layer)
        : rows_(layer.rows_out),
          rows_in_(layer.rows_in),
          in_(layer.channels_in),
          elu_(layer.elu),
          begin_(network.tensor(layer, "begin")),
          neighbour_(network.tensor(layer, "neighbour")),
          centre_(network.tensor(layer, "centre")),
          offset_(network.tensor(layer, "offset")),
          bias_(network.tensor(layer, "bias")),
          matrices_(static_cast<Index>(offset_.shape[0])),
          panel_(panel_rows(matrices_ * in_)) {
        steer_.pack(network.tensor(layer, "steer").floats(), in_, matrices_);
        weight_.pack(network.tensor(layer, "weight").floats(), matrices_ * in_, layer.channels_out);
        const std::uint32_t* begin = begin_.numbers();
        for (Index i = 0; i < rows_; ++i)
            degree_ = std::max<Index>(degree_, begin[i + 1] - begin[i]);
        shared_floats = static_cast<std::size_t>(2 * rows_in_ * matrices_);
        panel_floats =
            static_cast<std::size_t>(panel_ * (matrices_ * in_ + matrices_) + degree_ * matrices_);
        panel_pointers = static_cast<std::size_t>(panel_ + degree_);
    }

    void run(const float* in, float* out, const PanelLoop& panels) const override {
        float* raw = panels.shared();              // p: rows_in x M
        float* side = raw + rows_in_ * matrices_;  // exp(p - max p)
        prepare(in, raw, side, panels);
        panels.run(rows_, panel_, [&](Index first, Index count, PanelScratch& scratch) {
            mix_panel(in, raw, side, first, count, scratch);
            network_loops::Epilogue epilogue;
            epilogue.bias = bias_.floats();
            epilogue.elu = elu_;
            const float** rows = scratch.pointers.data();
            for (Index r = 0; r < count; ++r) rows[r] = scratch.floats.data() + r * matrices_ * in_;
            network_kernels().product(rows, count, 1, matrices_ * in_, weight_.data(),
                                      weight_.columns(), epilogue, out + first * weight_.columns(),
                                      weight_.columns());
        });
    }

  private:
    void prepare(const float* in, float* raw, float* side, const PanelLoop& panels) const {
        panels.run(rows_in_, panel_, [&](Index first, Index count, PanelScratch& scratch) {
            const float** rows = scratch.pointers.data();
            for (Index r = 0; r < count; ++r) rows[r] = in + (first + r) * in_;
            float* p = raw + first * matrices_;
            network_kernels().product(rows, count, 1, in_, steer_.data(), matrices_, {}, p,
                                      matrices_);
            float* e = side + first * matrices_;
            for (Index r = 0; r < count; ++r) shift(p + r * matrices_, e + r * matrices_);
            network_kernels().exponentials(e, count * matrices_);
        });
    }
    void shift(const float* from, float* to) const {
        float largest = from[0];
        for (Index m = 1; m < matrices_; ++m) largest = std::max(largest, from[m]);
        for (Index m = 0; m < matrices_; ++m) to[m] = from[m] - largest;
    }

    void mix_panel(const float* in, const float* raw, const float* side, Index first, Index count,
                   PanelScratch& scratch) const {
        float* mixed = scratch.floats.data();
        float* centre = mixed + panel_ * matrices_ * in_;  // exp(c - p_c - max), panel x M
        float* weights = centre + panel_ * matrices_;      // q / |N|, degree x M
        const float** neighbours = scratch.pointers.data() + panel_;
        for (Index r = 0; r < count; ++r) {
            const float* p = raw + static_cast<Index>(centre_.numbers()[first + r]) * matrices_;
            float* c = centre + r * matrices_;
            for (Index m = 0; m < matrices_; ++m) c[m] = offset_.floats()[m] - p[m];
            shift(c, c);
        }
        network_kernels().exponentials(centre, count * matrices_);
        for (Index r = 0; r < count; ++r) {
            const std::uint32_t* begin = begin_.numbers() + first + r;
            const auto degree = static_cast<Index>(begin[1] - begin[0]);
            for (Index k = 0; k < degree; ++k) {
                const auto j = static_cast<Index>(neighbour_.numbers()[begin[0] + k]);
                neighbours[k] = in + j * in_;
                steer(side + j * matrices_, centre + r * matrices_, raw + j * matrices_,
                      raw + static_cast<Index>(centre_.numbers()[first + r]) * matrices_, degree,
                      weights + k * matrices_);
            }
            network_kernels().mix(neighbours, degree, weights, matrices_, in_,
                                  mixed + r * matrices_ * in_);
        }
    }

    void steer(const float* neighbour, const float* centre, const float* p_neighbour,
               const float* p_centre, Index degree, float* weights) const {
        float sum = 0;
        for (Index m = 0; m < matrices_; ++m) {
            weights[m] = neighbour[m] * centre[m];
            sum += weights[m];
        }
        constexpr float kUnderflow = 1e-20f;  // above it no share that counts was a denormal number
        if (sum < kUnderflow) {
            double largest = -std::numeric_limits<double>::infinity(), total = 0;
            const auto argument = [&](Index m) {
                return static_cast<double>(p_neighbour[m]) - static_cast<double>(p_centre[m]) +
                       static_cast<double>(offset_.floats()[m]);
            };
            for (Index m = 0; m < matrices_; ++m) largest = std::max(largest, argument(m));
            for (Index m = 0; m < matrices_; ++m) total += std::exp(argument(m) - largest);
            for (Index m = 0; m < matrices_; ++m)
                weights[m] = static_cast<float>(std::exp(argument(m) - largest) / total);
            sum = 1;
        }
        const float factor = 1.0f / (sum * static_cast<float>(degree));
        for (Index m = 0; m < matrices_; ++m) weights[m] *= factor;
    }

    Index rows_, rows_in_, in_;
    bool elu_;
    NetworkTensor begin_, neighbour_, centre_, offset_, bias_;
    Index matrices_, panel_, degree_ = 0;
    PackedMatrix steer_, weight_;
};

}  // namespace

std::unique_ptr<NetworkStep> make_steered_step(const NetworkLayers& network,
                                               const NetworkLayer& layer) {
    return std::make_unique<SteeredStep>(network, layer);
}

}  // namespace mien
