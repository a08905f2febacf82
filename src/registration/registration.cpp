#include "registration/registration.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "geometry/alignment.hpp"
#include "geometry/normals.hpp"
#include "registration/nicp.hpp"

namespace mien {
namespace {

void check_options(const RegistrationOptions& o) {
    const auto positive = [](double value, const char* name) {
        if (!(value > 0) || !std::isfinite(value))
            fail(Status::invalid_argument, "registration: %s is %g, it must be above zero", name, value);
    };
    positive(o.landmark_sigma_mm, "landmark_sigma_mm");
    positive(o.sigma_start_mm, "sigma_start_mm");
    positive(o.sigma_end_mm, "sigma_end_mm");
    positive(o.robust_factor, "robust_factor");
    positive(o.data_weight, "data_weight");
    positive(o.pca_amplitude, "pca_amplitude");
    if (!(o.tangential >= 0 && o.tangential <= 1))
        fail(Status::invalid_argument, "registration: tangential is %g, it must be within 0 and 1", o.tangential);
    if (o.iterations < 1 || o.iterations > 10000)
        fail(Status::invalid_argument, "registration: %d iterations, give 1 to 10000", o.iterations);
}

// Pins in the model's order of names; names the model does not know are returned aside.
std::vector<Pin> match_landmarks(const DeformationModel& model, const std::vector<LandmarkPoint>& landmarks,
                                 double sigma_mm, std::vector<std::string>& unknown) {
    std::vector<Pin> pins;
    for (const LandmarkPoint& point : landmarks) {
        const auto known = std::find_if(model.landmarks.begin(), model.landmarks.end(),
                                        [&](const Landmark& l) { return l.name == point.name; });
        if (known == model.landmarks.end())
            unknown.push_back(point.name);
        else if (!point.point.allFinite())
            fail(Status::invalid_argument, "landmark '%s' is not finite", point.name.c_str());
        else
            pins.push_back({static_cast<Index>(known->vertex), point.point, sigma_mm});
    }
    return pins;
}

// Fills the verdict's measures from the finished fit.
void assess(const DeformationModel& model, const ScanSurface& scan, const std::vector<Pin>& pins,
            const FitState& state, RegistrationResult& result) {
    Verdict& v = result.verdict;
    const Index n = model.num_vertices();
    const double near = 3 * std::max(result.sigma_mm, 1.0);
    Index beside = 0, inliers = 0;
    double residual = 0;
    for (Index i = 0; i < n; ++i) {
        const SurfaceHit& hit = state.matches.hits[static_cast<std::size_t>(i)];
        if (!hit.valid() || scan.at_border(hit) || hit.distance() > 10) continue;
        ++beside;
        if (hit.distance() > near) continue;
        ++inliers;
        residual += hit.distance();
    }
    v.coverage = static_cast<double>(beside) / static_cast<double>(n);
    v.inlier_share = beside > 0 ? static_cast<double>(inliers) / static_cast<double>(beside) : 0;
    v.mean_residual_mm = inliers > 0 ? residual / static_cast<double>(inliers) : 0;
    double squares = 0;
    for (const Pin& pin : pins) squares += (state.places.row(pin.vertex).transpose() - pin.place).squaredNorm();
    v.landmarks_used = static_cast<int>(pins.size());
    v.landmark_rms_mm = pins.empty() ? 0 : std::sqrt(squares / static_cast<double>(pins.size()));
    const auto spread = [](const Points& points) {
        return std::sqrt((points.rowwise() - points.colwise().mean()).rowwise().squaredNorm().mean());
    };
    v.size_ratio = spread(state.places) / spread(model.template_mesh.vertices);
    double deviation = 0;
    const FitCoefficients& c = state.coefficients;
    if (c.pca.size() > 0) deviation = std::sqrt(c.pca.squaredNorm() / static_cast<double>(c.pca.size()));
    if (c.kernel.size() > 0)
        deviation = std::max<double>(deviation, std::sqrt(c.kernel.squaredNorm() / static_cast<double>(c.kernel.size())) /
                                                    state.kernel_amplitude);
    v.mean_deviation = deviation;
    judge(v, VerdictLimits());
}

}  // namespace

RegistrationResult register_scan(const DeformationModel& model, const TriMesh& scan_mesh,
                                 const std::vector<LandmarkPoint>& landmarks,
                                 const RegistrationOptions& options, const Context& context) {
    check_options(options);
    check_mesh(scan_mesh, "the scan");
    const Index n = model.num_vertices();
    RegistrationResult result;
    const std::vector<Pin> pins = match_landmarks(model, landmarks, options.landmark_sigma_mm,
                                                  result.unknown_landmarks);
    if (pins.size() < 3)
        fail(Status::not_found, "%lld of %lld landmarks are known to the model, at least 3 are needed",
             static_cast<long long>(pins.size()), static_cast<long long>(landmarks.size()));

    context.progress(Stage::alignment, 0);
    Points from(static_cast<Index>(pins.size()), 3), to(static_cast<Index>(pins.size()), 3);
    for (std::size_t k = 0; k < pins.size(); ++k) {
        from.row(static_cast<Index>(k)) = model.template_mesh.vertices.row(pins[k].vertex);
        to.row(static_cast<Index>(k)) = pins[k].place.transpose();
    }
    FitState state;
    state.motion = result.start = align_points(from, to, Vector(), options.estimate_scale);
    state.kernel_amplitude = options.kernel_amplitude > 0 ? options.kernel_amplitude : 1;
    const Index r = options.max_scalar_modes >= 0 ? std::min(options.max_scalar_modes, model.basis.cols)
                                                  : model.basis.cols;
    const Index p = options.max_pca_modes >= 0 ? std::min(options.max_pca_modes, model.pca_modes.cols)
                                               : model.pca_modes.cols;
    state.coefficients.kernel.setZero(r, 3);
    state.coefficients.pca.setZero(p);

    const ScanSurface scan = prepare_scan(scan_mesh, options.normal_smoothing_mm, context);
    context.progress(Stage::alignment, 0.5);
    fit_pins(model, pins, options, state, context);
    context.progress(Stage::alignment, 1);
    fit_surface(model, scan, Vector(), pins, options, state, context);

    result.sigma_mm = state.sigma_mm;
    result.fitted = model.template_mesh;
    result.fitted.vertices = state.places;
    result.fitted.colors.resize(0, 3);
    result.weight = state.final_weight;
    const Points normals = vertex_normals(state.places, model.template_mesh.triangles);
    state.matches.hits.clear();
    scan.tree.closest(state.places, 1e30, state.matches.hits, context);
    result.residual_mm.resize(n);
    for (Index i = 0; i < n; ++i) {
        const SurfaceHit& hit = state.matches.hits[static_cast<std::size_t>(i)];
        const double side = normals.row(i).dot(hit.point.transpose() - state.places.row(i));
        result.residual_mm[i] = side < 0 ? -hit.distance() : hit.distance();
    }
    result.confidence_mm = Vector::Zero(n);
    assess(model, scan, pins, state, result);
    result.correspondence = state.matches.hits;
    result.energy = std::move(state.energy);
    result.motion = state.motion;
    result.iterations = state.iterations;
    return result;
}

}  // namespace mien
