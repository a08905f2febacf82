#include "measure/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "geometry/normals.hpp"
#include "measure/area.hpp"
#include "measure/pair_check.hpp"

namespace mien {
namespace {

Vector checked_deviations(const Vector& sd, Index num_vertices, const char* what) {
    if (sd.size() == 0) return Vector::Zero(num_vertices);
    if (sd.size() != num_vertices)
        fail(Status::mismatch, "%lld deviations of the %s face for %lld vertices",
             static_cast<long long>(sd.size()), what, static_cast<long long>(num_vertices));
    for (Index v = 0; v < num_vertices; ++v)
        if (!(sd[v] >= 0) || !std::isfinite(sd[v]))
            fail_at(Status::invalid_argument, v,
                    "deviation %lld of the %s face is %g; deviations are zero or more",
                    static_cast<long long>(v), what, sd[v]);
    return sd;
}

}  // namespace

VolumePropagation::VolumePropagation(const PointsRef& before, const PointsRef& after,
                                     const TrianglesRef& triangles, const VolumeErrorModel& model)
    : model_(model) {
    check_faces_in_correspondence(before, after, triangles);
    if (!(model.correlation_length_mm >= 0) || !std::isfinite(model.correlation_length_mm) ||
        !(model.common_bias_mm >= 0) || !std::isfinite(model.common_bias_mm) ||
        !model.alignment_covariance.allFinite() || !model.alignment_centre.allFinite())
        fail(Status::invalid_argument,
             "correlation length %g, bias %g: both are finite and zero or more, the alignment's "
             "covariance is finite",
             model.correlation_length_mm, model.common_bias_mm);
    sd_before_ = checked_deviations(model.sd_before_mm, before.rows(), "before");
    sd_after_ = checked_deviations(model.sd_after_mm, before.rows(), "after");
    middle_ = 0.5 * (before + after);
    normals_ = vertex_normals(middle_, triangles);
    areas_ = vertex_areas(middle_, triangles);
}

VolumeUncertainty VolumePropagation::of(const std::vector<char>& inside,
                                        const Context& context) const {
    if (static_cast<Index>(inside.size()) != middle_.rows())
        fail(Status::mismatch, "a set over %zu vertices for %lld", inside.size(),
             static_cast<long long>(middle_.rows()));
    Vector loads = areas_;
    for (Index v = 0; v < loads.size(); ++v)
        if (!inside[static_cast<std::size_t>(v)]) loads[v] = 0.0;
    return of_loads(loads, context);
}

VolumeUncertainty VolumePropagation::of_loads(const Vector& loads_mm2,
                                              const Context& context) const {
    const Index num_vertices = middle_.rows();
    if (loads_mm2.size() != num_vertices)
        fail(Status::mismatch, "%lld loads for %lld vertices",
             static_cast<long long>(loads_mm2.size()), static_cast<long long>(num_vertices));
    // Sorted along x, so that only neighbours within the cut-off are visited.
    std::vector<Index> order;
    for (Index v = 0; v < num_vertices; ++v)
        if (loads_mm2[v] != 0) order.push_back(v);
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return middle_(a, 0) < middle_(b, 0); });
    const std::size_t n = order.size();
    Points points(static_cast<Index>(n), 3);
    Vector load_before(static_cast<Index>(n)), load_after(static_cast<Index>(n));
    Eigen::Matrix<double, 6, 1> motion = Eigen::Matrix<double, 6, 1>::Zero();
    double area = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const Index v = order[i], row = static_cast<Index>(i);
        points.row(row) = middle_.row(v);
        load_before[row] = loads_mm2[v] * sd_before_[v];
        load_after[row] = loads_mm2[v] * sd_after_[v];
        const Vector3 normal = normals_.row(v);
        const Vector3 arm = Vector3(middle_.row(v)) - model_.alignment_centre;
        motion.head<3>() += loads_mm2[v] * arm.cross(normal);
        motion.tail<3>() += loads_mm2[v] * normal;
        area += loads_mm2[v];
    }
    const double length = model_.correlation_length_mm;
    const double cutoff = 4.0 * length;  // exp(-8) = 3e-4 there
    const double factor = length > 0 ? -0.5 / (length * length) : 0.0;
    const double noise =
        parallel_sum(context, n, 256, 0.0, [&](std::size_t begin, std::size_t end) {
            double sum = 0.0;
            for (std::size_t a = begin; a < end; ++a) {
                const Index i = static_cast<Index>(a);
                sum += load_before[i] * load_before[i] + load_after[i] * load_after[i];
                for (Index j = i + 1; j < static_cast<Index>(n); ++j) {
                    if (points(j, 0) - points(i, 0) > cutoff) break;
                    const double squared = (points.row(j) - points.row(i)).squaredNorm();
                    if (squared > cutoff * cutoff || !(length > 0)) continue;
                    sum += 2.0 * std::exp(factor * squared) *
                           (load_before[i] * load_before[j] + load_after[i] * load_after[j]);
                }
            }
            return sum;
        });
    VolumeUncertainty result;
    result.noise_ml = std::sqrt(std::max(0.0, noise)) * 1e-3;
    result.alignment_ml =
        std::sqrt(std::max(0.0, motion.dot(model_.alignment_covariance * motion))) * 1e-3;
    result.bias_ml = model_.common_bias_mm * std::fabs(area) * 1e-3;
    result.sd_ml =
        std::sqrt(result.noise_ml * result.noise_ml + result.alignment_ml * result.alignment_ml +
                  result.bias_ml * result.bias_ml);
    return result;
}

Vector VolumePropagation::total_sd_mm() const {
    Vector total(middle_.rows());
    for (Index v = 0; v < total.size(); ++v) {
        Eigen::Matrix<double, 6, 1> motion;
        const Vector3 normal = normals_.row(v);
        motion << (Vector3(middle_.row(v)) - model_.alignment_centre).cross(normal), normal;
        total[v] = std::sqrt(sd_before_[v] * sd_before_[v] + sd_after_[v] * sd_after_[v] +
                             std::max(0.0, motion.dot(model_.alignment_covariance * motion)) +
                             model_.common_bias_mm * model_.common_bias_mm);
    }
    return total;
}

}  // namespace mien
