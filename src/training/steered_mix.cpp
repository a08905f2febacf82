#include "training/steered_mix.hpp"

namespace mien::training {
namespace {

using torch::Tensor;

/// y += a x
template <typename Real>
void add_scaled(Real a, const Real* x, Real* y, int64_t count) {
    for (int64_t c = 0; c < count; ++c) y[c] += a * x[c];
}

/// In eight sums, so that the compiler may take a whole register at a time.
template <typename Real>
Real dot(const Real* x, const Real* y, int64_t count) {
    constexpr int64_t kSums = 8;
    Real sums[kSums] = {};
    int64_t c = 0;
    for (; c + kSums <= count; c += kSums)
        for (int64_t s = 0; s < kSums; ++s) sums[s] += x[c + s] * y[c + s];
    Real sum =
        ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
    for (; c < count; ++c) sum += x[c] * y[c];
    return sum;
}

struct Sizes {
    Sizes(const Tensor& steer, const Tensor& x)
        : batch(steer.size(0)),
          rows(steer.size(1)),
          places(steer.size(2)),
          matrices(steer.size(3)),
          rows_in(x.size(1)),
          channels(x.size(2)) {}
    int64_t batch, rows, places, matrices, rows_in, channels;
};

template <typename Real>
void mix(const Sizes& n, const Real* steer, const Real* x, const int64_t* neighbour,
         const int64_t* entries, Real* mixed) {
    for (int64_t b = 0; b < n.batch; ++b, x += n.rows_in * n.channels)
        for (int64_t i = 0; i < n.rows; ++i) {
            for (int64_t k = 0; k < entries[i]; ++k) {
                const Real* from = x + neighbour[i * n.places + k] * n.channels;
                for (int64_t m = 0; m < n.matrices; ++m)
                    add_scaled(steer[k * n.matrices + m], from, mixed + m * n.channels, n.channels);
            }
            steer += n.places * n.matrices;
            mixed += n.matrices * n.channels;
        }
}

template <typename Real>
void mix_back(const Sizes& n, const Real* steer, const Real* x, const int64_t* neighbour,
              const int64_t* entries, const Real* of_mixed, Real* of_steer, Real* of_x) {
    for (int64_t b = 0; b < n.batch;
         ++b, x += n.rows_in * n.channels, of_x += n.rows_in * n.channels)
        for (int64_t i = 0; i < n.rows; ++i) {
            for (int64_t k = 0; k < entries[i]; ++k) {
                const int64_t from = neighbour[i * n.places + k] * n.channels;
                for (int64_t m = 0; m < n.matrices; ++m) {
                    const Real* const gradient = of_mixed + m * n.channels;
                    of_steer[k * n.matrices + m] = dot(gradient, x + from, n.channels);
                    add_scaled(steer[k * n.matrices + m], gradient, of_x + from, n.channels);
                }
            }
            steer += n.places * n.matrices;
            of_steer += n.places * n.matrices;
            of_mixed += n.matrices * n.channels;
        }
}

class SteeredMix : public torch::autograd::Function<SteeredMix> {
  public:
    static Tensor forward(torch::autograd::AutogradContext* context, const Tensor& steer_given,
                          const Tensor& x_given, const Tensor& neighbour, const Tensor& entries) {
        const Tensor steer = steer_given.contiguous(), x = x_given.contiguous();
        context->save_for_backward({steer, x, neighbour, entries});
        const Sizes n(steer, x);
        Tensor mixed = torch::zeros({n.batch, n.rows, n.matrices * n.channels}, x.options());
        AT_DISPATCH_FLOATING_TYPES(x.scalar_type(), "steered_mix", [&] {
            mix(n, steer.data_ptr<scalar_t>(), x.data_ptr<scalar_t>(),
                neighbour.data_ptr<int64_t>(), entries.data_ptr<int64_t>(),
                mixed.data_ptr<scalar_t>());
        });
        return mixed;
    }

    static torch::autograd::variable_list backward(torch::autograd::AutogradContext* context,
                                                   torch::autograd::variable_list gradients) {
        const auto saved = context->get_saved_variables();
        const Tensor &steer = saved[0], &x = saved[1];
        const Tensor of_mixed = gradients[0].contiguous();
        Tensor of_steer = torch::zeros_like(steer), of_x = torch::zeros_like(x);
        AT_DISPATCH_FLOATING_TYPES(x.scalar_type(), "steered_mix_back", [&] {
            mix_back(Sizes(steer, x), steer.data_ptr<scalar_t>(), x.data_ptr<scalar_t>(),
                     saved[2].data_ptr<int64_t>(), saved[3].data_ptr<int64_t>(),
                     of_mixed.data_ptr<scalar_t>(), of_steer.data_ptr<scalar_t>(),
                     of_x.data_ptr<scalar_t>());
        });
        return {of_steer, of_x, Tensor(), Tensor()};
    }
};

}  // namespace

Tensor steered_mix(const Tensor& steer, const Tensor& x, const Tensor& neighbour,
                   const Tensor& entries) {
    return x.device().is_cpu() ? Tensor(SteeredMix::apply(steer, x, neighbour, entries))
                               : steered_mix_by_products(steer, x, neighbour);
}

Tensor steered_mix_by_products(const Tensor& steer, const Tensor& x, const Tensor& neighbour) {
    const Sizes n(steer, x);
    const Tensor rows = x.index_select(1, neighbour).view({n.batch, n.rows, n.places, n.channels});
    return torch::matmul(steer.transpose(2, 3), rows)
        .reshape({n.batch, n.rows, n.matrices * n.channels});
}

}  // namespace mien::training
