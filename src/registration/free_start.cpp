#include "registration/free_start.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <Eigen/Geometry>

#include "geometry/normals.hpp"

namespace mien {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

// How much of the jaw's turn a landmark of the 68-point scheme takes part in: 1 at the chin and the
// lower lip; negative where the cheek pulls and nothing is known.
double share_of_jaw(const std::string& name) {
    const auto number = [&](const std::string& prefix) {
        return name.compare(0, prefix.size(), prefix) == 0 ? std::atoi(name.c_str() + prefix.size())
                                                           : -1;
    };
    if (int k = number("jaw_"); k >= 0) {
        const int from_ear = std::min(k, 16 - k);
        if (from_ear >= 7) return 1;
        if (from_ear <= 1) return 0;
        return from_ear == 6 ? 0.8 : from_ear == 5 ? 0.5 : from_ear == 4 ? 0.3 : -1;
    }
    if (int k = number("mouth_outer_"); k >= 0) return k == 0 || k == 6 ? 0.4 : (k > 6 ? 1 : 0);
    if (int k = number("mouth_inner_"); k >= 0) return k == 0 || k == 4 ? 0.4 : (k > 4 ? 1 : 0);
    return 0;
}

// 0 to 1: the mean over the open skin within 100 mm of the nose's tip of exp(-d^2 / 2 s^2) cos^4 of
// the normals, s = 2 mm. Unlike a residual it counts what has found no scan. Where the scan has
// colours, a tenth of their mean agreement is added.
double agreement(const DeformationModel& model, const ScanSurface& scan,
                 const CorrespondenceOptions& match, const FitState& state,
                 const Context& context) {
    constexpr double kScale_mm = 2, kRadius_mm = 100;
    const Points& rest = model.template_mesh.vertices;
    std::vector<SurfaceHit> hits;
    scan.tree.closest(state.places, 4 * kScale_mm, hits, context);
    const Points normals = vertex_normals(state.places, model.template_mesh.triangles);
    Index tip;
    rest.col(2).maxCoeff(&tip);
    double sum = 0;
    Index counted = 0;
    for (Index i = 0; i < rest.rows(); ++i) {
        const std::size_t v = static_cast<std::size_t>(i);
        if (state.inner[v] || (rest.row(i) - rest.row(tip)).norm() > kRadius_mm) continue;
        ++counted;
        if (!hits[v].valid() || scan.at_border(hits[v])) continue;
        const double cosine = normals.row(i).dot(scan.normal_at(hits[v]).transpose());
        if (cosine > 0)
            sum += std::pow(cosine, 4) *
                   std::exp(-0.5 * hits[v].squared_distance / (kScale_mm * kScale_mm));
    }
    if (counted == 0) return 0;
    double colors = 0;
    if (state.colors) {
        const std::vector<ColorAgreement> features =
            state.colors->agreements(state.places, normals, match, context);
        for (const ColorAgreement& feature : features)
            colors += feature.correlation / static_cast<double>(features.size());
    }
    return sum / static_cast<double>(counted) + 0.1 * colors;
}

// Every fifth vertex, in every round.
RegistrationOptions rough_options(const RegistrationOptions& options) {
    RegistrationOptions rough = options;
    rough.sigma_end_mm = options.sigma_start_mm;
    rough.sparse_rounds = 2;
    rough.sparse_stride = 5;
    return rough;
}

// Few modes, all of them at rest.
FitState rough_state(const FitState& state, Index scalar_modes, Index pca_modes) {
    FitState rough;
    rough.motion = state.motion;
    rough.kernel_amplitude = state.kernel_amplitude;
    rough.inner = state.inner;
    rough.colors = state.colors;
    rough.coefficients.kernel.setZero(scalar_modes, 3);
    rough.coefficients.pca.setZero(pca_modes);
    return rough;
}

// The opening that agrees with the scan clearly better than what the approach found, all under the
// same prior: a jaw moves by centimetres, so it is given twice the amplitude. An opening of zero
// starts again without the approach's own idea of the mouth.
void try_openings(const DeformationModel& model, const ScanSurface& scan, const Vector& scan_weight,
                  const RegistrationOptions& options, const FitState& start, FitState& rough,
                  const Context& context, const Context& quiet) {
    constexpr double kOpenings[] = {0, 10 * kDegree, 20 * kDegree, 30 * kDegree};
    constexpr double kAmplitude = 2, kClearly = 0.01;
    RegistrationOptions closer = rough_options(options);
    closer.sigma_start_mm = options.approach_sigma_mm / 3;
    closer.iterations = 12;
    closer.tangential = 0.05;
    const Index modes = std::min<Index>(start.coefficients.kernel.rows(), 80);
    const double amplitude = options.kernel_amplitude > 0 ? 1 : kAmplitude;
    if (open_jaw(model, start, 0).empty()) return;
    FitState trial = rough;
    trial.coefficients.kernel.conservativeResizeLike(Eigen::MatrixXf::Zero(modes, 3));
    trial.kernel_amplitude *= amplitude;
    fit_surface(model, scan, scan_weight, {}, closer, trial, quiet);
    double best = agreement(model, scan, options.correspondence, trial, context) + kClearly;
    for (const double opening : kOpenings) {
        trial = rough_state(start, modes, 0);
        trial.kernel_amplitude *= amplitude;
        fit_pins(model, open_jaw(model, trial, opening), options, trial, quiet);
        fit_surface(model, scan, scan_weight, {}, closer, trial, quiet);
        context.progress(Stage::alignment, 0.94 + 0.05 * opening / kOpenings[3]);
        const double agrees = agreement(model, scan, options.correspondence, trial, context);
        context.log(LogLevel::debug, "jaw opened by %.0f degrees: agreement %.4f",
                    opening / kDegree, agrees);
        if (agrees <= best) continue;
        best = agrees;
        rough = trial;
        if (opening == 0) rough.kernel_amplitude = start.kernel_amplitude;
    }
}

}  // namespace

std::vector<Pin> open_jaw(const DeformationModel& model, const FitState& state,
                          double opening_rad) {
    Points shape = model.template_mesh.vertices;
    if (state.displacement.rows() == shape.rows())
        shape += state.displacement;
    else if (model.mean_displacement.rows() > 0)
        shape += model.mean_displacement;
    const auto place = [&](const char* name, Vector3& at) {
        for (const Landmark& landmark : model.landmarks)
            if (landmark.name == name) return at = shape.row(landmark.vertex).transpose(), true;
        return false;
    };
    Vector3 right, left, angle, lip;
    if (!place("jaw_00", right) || !place("jaw_16", left) || !place("jaw_03", angle) ||
        !place("mouth_outer_09", lip))
        return {};
    const double width = (left - right).norm();
    if (!(width > 0)) return {};
    // The condyles slide forward while they turn: as a whole it is a turn about a line behind the
    // jaw's angles.
    right[1] = left[1] = angle[1];
    right[2] -= 0.12 * width;
    left[2] -= 0.12 * width;
    const Vector3 axis = (left - right).normalized();
    const double down = axis.cross(lip - 0.5 * (left + right))[1] > 0 ? -1 : 1;
    std::vector<Pin> pins;
    for (const Landmark& landmark : model.landmarks) {
        const double share = share_of_jaw(landmark.name);
        if (share < 0) continue;
        const Eigen::AngleAxisd turn(share * down * opening_rad, axis);
        const Vector3 from = shape.row(landmark.vertex).transpose();
        pins.push_back({static_cast<Index>(landmark.vertex),
                        state.motion.apply(Vector3(right + turn * (from - right))), 1.5});
    }
    return pins;
}

void start_freely(const DeformationModel& model, const ScanSurface& scan, const Vector& scan_weight,
                  const RegistrationOptions& options, FitState& state, const Context& context) {
    RegistrationOptions first = rough_options(options);
    first.sigma_start_mm = options.approach_sigma_mm;
    first.iterations = options.approach_rounds;
    first.data_weight = options.approach_weight;
    first.tangential = options.approach_tangential;
    const Index p = std::min<Index>(state.coefficients.pca.size(), options.approach_pca_modes);
    const Index r =
        p > 0 ? 0
              : std::min<Index>(state.coefficients.kernel.rows(), options.approach_scalar_modes);
    FitState rough = rough_state(state, r, p);
    Context quiet = context;  // fits report a stage that is still to come
    quiet.progress_function = nullptr;
    fit_surface(model, scan, scan_weight, {}, first, rough, quiet);
    context.progress(Stage::alignment, 0.93);
    if (p == 0) try_openings(model, scan, scan_weight, options, state, rough, context, quiet);
    state.motion = rough.motion;
    state.places = std::move(rough.places);
    state.kernel_amplitude = rough.kernel_amplitude;
    state.coefficients.kernel.topRows(rough.coefficients.kernel.rows()) = rough.coefficients.kernel;
    state.coefficients.pca.head(p) = rough.coefficients.pca;
}

}  // namespace mien
