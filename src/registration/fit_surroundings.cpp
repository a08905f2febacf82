#include "registration/fit_surroundings.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "geometry/alignment.hpp"
#include "geometry/normals.hpp"
#include "model/mirror.hpp"

namespace mien {
namespace {

constexpr std::size_t kVerticesAtOnce = 1024;

// Distances to the face's own mirror image, laid over it. `partner`: each vertex' mirror image.
Vector mirror_distance(const MeasuredFit& f, const std::vector<std::uint32_t>& partner,
                       const std::vector<std::uint8_t>& whole) {
    const Index n = f.places.rows();
    Points mirrored(n, 3);
    Vector weight(n);
    for (Index i = 0; i < n; ++i) {
        const std::size_t k = static_cast<std::size_t>(i);
        mirrored.row(i) = f.places.row(partner[k]);
        weight[i] = whole[k] && !f.prior.inner[k] ? 1 : 0;
    }
    mirrored.col(0) *= -1;
    const Similarity motion = align_points(mirrored, f.places, weight, false);
    return (motion.apply(mirrored) - f.places).rowwise().norm();
}

// Zero when the template is no mirror image of itself, or too flat to be laid over anything.
Vector asymmetry(const MeasuredFit& f, const std::vector<std::uint8_t>& whole,
                 const Context& context) {
    try {
        return mirror_distance(f, mirror_map(f.model.template_mesh, context), whole);
    } catch (const Error& error) {
        if (error.status() != Status::invalid_mesh && error.status() != Status::no_solution) throw;
        return Vector::Zero(f.places.rows());
    }
}

// Squared displacements over the prior's variances. `shape_modes`: the kernel's that count.
Vector squared_shape(const MeasuredFit& f, const Points& opening, Index shape_modes) {
    const FitState& state = f.fit.state;
    const Index n = f.places.rows();
    if (state.displacement.rows() != n) return Vector::Zero(n);
    const Points& mean = f.model.mean_displacement;
    const Index r = std::min<Index>(state.coefficients.kernel.rows(), shape_modes);
    Eigen::VectorXf kernel = Eigen::VectorXf::Zero(n), trained = Eigen::VectorXf::Zero(3 * n);
    for (Index j = 0; j < r; ++j) kernel += f.model.basis.map().col(j).cwiseAbs2();
    for (Index j = 0; j < state.coefficients.pca.size(); ++j)
        trained += f.model.pca_modes.map().col(j).cwiseAbs2();
    const double amplitude2 = state.kernel_amplitude * state.kernel_amplitude;
    Vector shape2 = Vector::Zero(n);
    for (Index i = 0; i < n; ++i) {
        Vector3 moved = (state.displacement.row(i) - opening.row(i)).transpose();
        if (mean.rows() == n) moved -= mean.row(i).transpose();
        const double variance = 3 * amplitude2 * static_cast<double>(kernel[i]) +
                                static_cast<double>(trained.segment(3 * i, 3).sum());
        if (variance > 0) shape2[i] = moved.squaredNorm() / variance;
    }
    return shape2;
}

// Movement along the skin between the start and the end.
Vector slide(const MeasuredFit& f) {
    const Points& rest = f.model.template_mesh.vertices;
    const Points before = f.start.state.places.rows() == rest.rows() ? f.start.state.places
                                                                     : f.start.motion.apply(rest);
    const Points normals = vertex_normals(f.places, f.model.template_mesh.triangles);
    Vector slid(rest.rows());
    for (Index i = 0; i < rest.rows(); ++i) {
        const Vector3 moved = (f.places.row(i) - before.row(i)).transpose();
        const Vector3 normal = normals.row(i).transpose();
        slid[i] = (moved - normal.dot(moved) * normal).norm();
    }
    return slid;
}

// Calls look_at(vertex) on all threads.
template <typename LookAt>
void for_open_vertices(const MeasuredFit& f, const Context& context, LookAt&& look_at) {
    parallel_for(context, f.prior.inner.size(), kVerticesAtOnce,
                 [&](std::size_t begin, std::size_t end) {
                     for (std::size_t k = begin; k < end; ++k)
                         if (!f.prior.inner[k]) look_at(static_cast<Index>(k));
                 });
}

void measure_pins(const MeasuredFit& f, const ZoneMeasureSettings& settings, PlaceMeasures& out,
                  const Context& context) {
    const Points& rest = f.model.template_mesh.vertices;
    out.pin_far_mm = Vector::Constant(rest.rows(), settings.far_mm);
    out.pin_misfit_mm = Vector::Zero(rest.rows());
    constexpr double kSomeWeight = 0.1;  // of a far landmark: what it says fades with distance
    std::vector<double> misfit2;
    for (const Pin& pin : f.start.pins)
        misfit2.push_back((f.places.row(pin.vertex).transpose() - pin.place).squaredNorm());
    const auto look_at = [&](Index i) {
        double sum = kSomeWeight, squares = 0, nearest2 = settings.far_mm * settings.far_mm;
        for (std::size_t k = 0; k < misfit2.size(); ++k) {
            const double far2 = (rest.row(i) - rest.row(f.start.pins[k].vertex)).squaredNorm();
            nearest2 = std::min(nearest2, far2);
            const double weight = std::exp(-far2 / (2 * settings.near_mm * settings.near_mm));
            sum += weight;
            squares += weight * misfit2[k];
        }
        out.pin_far_mm[i] = std::sqrt(nearest2);
        out.pin_misfit_mm[i] = std::sqrt(squares / sum);
    };
    for_open_vertices(f, context, look_at);
}

void measure_colors(const MeasuredFit& f, const std::vector<ColorAgreement>& colors,
                    const ZoneMeasureSettings& settings, PlaceMeasures& out,
                    const Context& context) {
    const Points& rest = f.model.template_mesh.vertices;
    out.color_hold = out.color_doubt = Vector::Zero(rest.rows());
    for (const ColorAgreement& feature : colors) {
        if (feature.centre < 0) continue;
        for_open_vertices(f, context, [&](Index i) {
            const double far2 = (rest.row(i) - rest.row(feature.centre)).squaredNorm();
            const double near = std::exp(-far2 / (2 * settings.near_mm * settings.near_mm));
            out.color_hold[i] =
                std::max(out.color_hold[i], near * std::max(0.0, feature.correlation));
            out.color_doubt[i] =
                std::max(out.color_doubt[i], near * (feature.trust - feature.correlation));
        });
    }
}

}  // namespace

Points expected_opening(const DeformationModel& model, const FitState& state) {
    if (state.kernel_mean.rows() == 0) return Points::Zero(model.num_vertices(), 3);
    const Eigen::MatrixXf opening =
        model.basis.map().leftCols(state.kernel_mean.rows()) * state.kernel_mean;
    return opening.cast<double>();
}

PlaceMeasures measure_places(const MeasuredFit& finished, const Points& opening,
                             const std::vector<std::uint8_t>& whole,
                             const std::vector<ColorAgreement>& colors,
                             const ZoneMeasureSettings& settings, const Context& context) {
    PlaceMeasures out;
    out.asymmetry_mm = asymmetry(finished, whole, context);
    out.shape2 = squared_shape(finished, opening, settings.shape_modes);
    out.slid_mm = slide(finished);
    measure_pins(finished, settings, out, context);
    measure_colors(finished, colors, settings, out, context);
    return out;
}

}  // namespace mien
