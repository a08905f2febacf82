#include "study/slide_error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/parallel.hpp"

namespace mien {
namespace {

constexpr double kReach = 4.0;  ///< correlation lengths; exp(-8) = 3e-4 there
/// A slope below this share of the largest is rounding: inside a zone the slopes of its triangles
/// cancel.
constexpr double kSmallSlope = 1e-6;

}  // namespace

double slide_sd(const Context& context, const Points& points, const Points& slopes,
                const Vector& place_sd_before_mm, const Vector& place_sd_after_mm,
                double correlation_length_mm) {
    const Vector lengths = slopes.rowwise().norm();
    const double least = kSmallSlope * (lengths.size() == 0 ? 0.0 : lengths.maxCoeff());
    std::vector<Index> order;
    for (Index v = 0; v < points.rows(); ++v)
        if (lengths[v] > least) order.push_back(v);
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return points(a, 0) < points(b, 0); });
    const double length = correlation_length_mm, cutoff = kReach * length;
    const double factor = length > 0 ? -0.5 / (length * length) : 0.0;
    const auto pair = [&](Index i, Index j) {
        return slopes.row(i).dot(slopes.row(j)) * (place_sd_before_mm[i] * place_sd_before_mm[j] +
                                                   place_sd_after_mm[i] * place_sd_after_mm[j]);
    };
    const double sum =
        parallel_sum(context, order.size(), 256, 0.0, [&](std::size_t begin, std::size_t end) {
            double part = 0.0;
            for (std::size_t a = begin; a < end; ++a) {
                const Index i = order[a];
                part += pair(i, i);
                for (std::size_t b = a + 1; b < order.size() && length > 0; ++b) {
                    const Index j = order[b];
                    if (points(j, 0) - points(i, 0) > cutoff) break;
                    const double squared = (points.row(j) - points.row(i)).squaredNorm();
                    if (squared <= cutoff * cutoff)
                        part += 2.0 * std::exp(factor * squared) * pair(i, j);
                }
            }
            return part;
        });
    return std::sqrt(1.5 * std::max(0.0, sum));
}

}  // namespace mien
