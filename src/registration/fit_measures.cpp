#include "registration/fit_measures.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/normals.hpp"
#include "model/landmarks.hpp"
#include "registration/fit_surroundings.hpp"

namespace mien {
namespace {

constexpr const char* kWhole = "face";

// Per vertex: what a zone averages.
struct VertexMeasures {
    std::vector<std::uint8_t> open, seen;
    Vector seen_share, residual_mm, open_mm, turn, stretch2;
    PlaceMeasures around;
};

// Value that a share of `values` stays below; 0 of none. Reorders them.
double quantile(std::vector<double>& values, double share) {
    if (values.empty()) return 0;
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

// Mean over each vertex' edges of the squared logarithm of their stretch, about the mean of those
// of `about`'s vertices.
Vector squared_stretch(const Points& rest, const Points& places, const Triangles& triangles,
                       const std::vector<std::uint8_t>& about, double most) {
    Vector sum = Vector::Zero(rest.rows()), squares = sum, count = sum;
    double mean = 0, edges = 0;
    const auto logarithm = [&](std::uint32_t a, std::uint32_t b) {
        const double before = (rest.row(a) - rest.row(b)).norm(),
                     after = (places.row(a) - places.row(b)).norm();
        return before > 0 && after > 0 ? std::log(after / before) : 0;
    };
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles(t, k), b = triangles(t, (k + 1) % 3);
            if (!about[a] || !about[b]) continue;
            mean += std::clamp(logarithm(a, b), -most, most);
            ++edges;
        }
    mean /= std::max(1.0, edges);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles(t, k), b = triangles(t, (k + 1) % 3);
            const double stretch = std::clamp(logarithm(a, b) - mean, -most, most);
            for (const std::uint32_t v : {a, b}) {
                squares[v] += stretch * stretch;
                ++count[v];
            }
        }
    return squares.cwiseQuotient(count.cwiseMax(1.0));
}

VertexMeasures measure_vertices(const MeasuredFit& f, const Points& opening,
                                const ZoneMeasureSettings& settings,
                                const std::vector<std::uint8_t>& whole) {
    const Index n = f.places.rows();
    const Triangles& triangles = f.model.template_mesh.triangles;
    const Points& modes = f.fit.state.places;
    const Points normals = vertex_normals(modes, triangles);
    VertexMeasures v;
    v.open.assign(static_cast<std::size_t>(n), 1);
    v.seen.assign(static_cast<std::size_t>(n), 0);
    v.seen_share = v.residual_mm = v.open_mm = v.turn = Vector::Zero(n);
    for (Index i = 0; i < n; ++i) {
        const std::size_t k = static_cast<std::size_t>(i);
        if (f.prior.inner[k]) {
            v.open[k] = 0;
            continue;
        }
        const SurfaceHit& hit = f.correspondence[k];
        if (f.start.scan.surface().at_border(hit) || hit.distance() > settings.beside_mm) continue;
        v.seen_share[i] = std::clamp(f.weight[i], 0.0, 1.0);
        if (f.weight[i] < settings.least_weight) continue;
        v.seen[k] = 1;
        v.residual_mm[i] = hit.distance();
        const Vector3 normal = f.start.scan.normal_at(hit);
        v.open_mm[i] = std::abs(normal.dot(hit.point - modes.row(i).transpose()));
        v.turn[i] = 1 - normal.dot(normals.row(i).transpose());
    }
    const Points rest = f.model.template_mesh.vertices + opening;
    v.stretch2 = squared_stretch(rest, f.places, triangles, whole, settings.most_stretch);
    return v;
}

ZoneMeasures measure_zone(const MeasuredFit& f, const VertexMeasures& v, std::string name,
                          const std::vector<std::uint8_t>& member, double most_share) {
    ZoneMeasures zone;
    zone.name = std::move(name);
    double open = 0, seen = 0, share = 0, stretch2 = 0, shape2 = 0;
    std::vector<double> opens;
    for (std::size_t k = 0; k < member.size(); ++k) {
        if (!member[k] || !v.open[k]) continue;
        const Index i = static_cast<Index>(k);
        ++open;
        share += v.seen_share[i];
        zone.deviation_mm += f.deviation_mm[i];
        stretch2 += v.stretch2[i];
        shape2 += v.around.shape2[i];
        zone.asymmetry_mm += v.around.asymmetry_mm[i];
        zone.slid_mm += v.around.slid_mm[i];
        zone.pin_far_mm += v.around.pin_far_mm[i];
        zone.pin_misfit_mm += v.around.pin_misfit_mm[i];
        zone.color_hold += v.around.color_hold[i];
        zone.color_doubt += v.around.color_doubt[i];
        if (!v.seen[k]) continue;
        opens.push_back(v.open_mm[i]);
        ++seen;
        zone.residual_mm += v.residual_mm[i];
        zone.open_mm += v.open_mm[i];
        zone.turn += v.turn[i];
    }
    zone.unseen = open > 0 ? 1 - share / open : 1;
    for (double* sum : {&zone.deviation_mm, &zone.asymmetry_mm, &zone.slid_mm, &zone.pin_far_mm,
                        &zone.pin_misfit_mm, &zone.color_hold, &zone.color_doubt})
        *sum /= std::max(1.0, open);
    zone.stretch = std::sqrt(stretch2 / std::max(1.0, open));
    zone.shape_deviation = std::sqrt(shape2 / std::max(1.0, open));
    zone.open_most_mm = quantile(opens, most_share);
    for (double* sum : {&zone.residual_mm, &zone.open_mm, &zone.turn}) *sum /= std::max(1.0, seen);
    double squares = 0;
    for (const Pin& pin : f.start.pins) {
        if (!member[static_cast<std::size_t>(pin.vertex)]) continue;
        ++zone.landmarks;
        squares += (f.places.row(pin.vertex).transpose() - pin.place).squaredNorm();
    }
    if (zone.landmarks > 0) zone.landmark_mm = std::sqrt(squares / zone.landmarks);
    return zone;
}

// Root mean square distance to the mean.
double spread(const Points& points) {
    const Eigen::RowVector3d mean = points.colwise().mean();
    return std::sqrt((points.rowwise() - mean).rowwise().squaredNorm().mean());
}

double root_mean_square(const Eigen::Ref<const Eigen::MatrixXf>& values) {
    if (values.size() == 0) return 0;
    return std::sqrt(static_cast<double>(values.squaredNorm()) /
                     static_cast<double>(values.size()));
}

std::vector<std::uint8_t> members_of(const Zone& zone, Index num_vertices) {
    std::vector<std::uint8_t> member(static_cast<std::size_t>(num_vertices), 0);
    for (const std::uint32_t v : zone.vertices) member[v] = 1;
    return member;
}

}  // namespace

WholeMeasures measure_whole(const MeasuredFit& f, double landmark_sigma_mm) {
    WholeMeasures whole;
    const FitState& state = f.fit.state;
    const StartState& start = f.start;
    if (start.searched) whole.search_miss = 1 - start.search_score;
    double squares = 0;
    for (const Pin& pin : start.pins)
        squares += (f.places.row(pin.vertex).transpose() - pin.place).squaredNorm();
    const double used = static_cast<double>(start.pins.size()),
                 out = static_cast<double>(start.rejected.size());
    if (used > 0) whole.landmark_misfit = std::sqrt(squares / used) / landmark_sigma_mm;
    if (used + out > 0) whole.landmarks_out = out / (used + out);
    whole.trained_deviation = root_mean_square(state.coefficients.pca);
    if (state.coefficients.kernel.size() > 0)
        whole.kernel_deviation = root_mean_square(state.kernel_off()) / state.kernel_amplitude;
    whole.kernel_mm =
        state.kernel_amplitude * kernel_deviation_mm(f.model, state.coefficients.kernel.rows());
    whole.size = std::abs(std::log(spread(f.places) / spread(f.model.template_mesh.vertices)));
    whole.is_free = start.is_free() ? 1 : 0;
    whole.is_trained = state.coefficients.pca.size() > 0 ? 1 : 0;
    whole.landmarks = used;
    return whole;
}

std::vector<ZoneMeasures> measure_zones(const MeasuredFit& finished,
                                        const std::vector<ColorAgreement>& colors,
                                        const ZoneMeasureSettings& settings,
                                        const Context& context) {
    const Index n = finished.places.rows();
    const Zone* face = find_zone(finished.model.zones, kWhole);
    const std::vector<std::uint8_t> whole =
        face != nullptr ? members_of(*face, n)
                        : std::vector<std::uint8_t>(static_cast<std::size_t>(n), 1);
    const Points opening = expected_opening(finished.model, finished.fit.state);
    VertexMeasures vertices = measure_vertices(finished, opening, settings, whole);
    vertices.around = measure_places(finished, opening, whole, colors, settings, context);
    std::vector<ZoneMeasures> zones{
        measure_zone(finished, vertices, kWhole, whole, settings.most_share)};
    for (const Zone& zone : finished.model.zones)
        if (&zone != face)
            zones.push_back(measure_zone(finished, vertices, zone.name, members_of(zone, n),
                                         settings.most_share));
    return zones;
}

}  // namespace mien
