#include "registration/registration.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

#include "base/error.hpp"
#include "geometry/normals.hpp"
#include "mesh/cleaning.hpp"
#include "model/sampling.hpp"
#include "registration/confidence.hpp"
#include "registration/free_start.hpp"
#include "registration/inner.hpp"
#include "registration/nicp.hpp"
#include "registration/refine.hpp"
#include "registration/shut_lids.hpp"
#include "registration/skin.hpp"
#include "registration/start.hpp"

namespace mien {
namespace {

constexpr double kGoodSearch = 0.45;  // of a search's score; a right pose reaches 0.6 to 0.9

void check_options(const RegistrationOptions& o, const TriMesh& scan) {
    const auto positive = [](double value, const char* name) {
        if (!(value > 0) || !std::isfinite(value))
            fail(Status::invalid_argument, "registration: %s is %g, it must be above zero", name,
                 value);
    };
    positive(o.landmark_sigma_mm, "landmark_sigma_mm");
    positive(o.sigma_start_mm, "sigma_start_mm");
    positive(o.sigma_end_mm, "sigma_end_mm");
    positive(o.robust_factor, "robust_factor");
    positive(o.pca_amplitude, "pca_amplitude");
    positive(o.correspondence.max_angle_deg, "max_angle_deg");
    if (!(o.normal_length_mm >= 0) || !std::isfinite(o.normal_length_mm))
        fail(Status::invalid_argument,
             "registration: normal_length_mm is %g, it must not be negative", o.normal_length_mm);
    positive(o.data_weight, "data_weight");
    if (!(o.kernel_amplitude >= 0))
        fail(Status::invalid_argument, "registration: kernel_amplitude must not be negative");
    if (!(o.tangential >= 0 && o.tangential <= 1))
        fail(Status::invalid_argument, "registration: tangential is %g, it must be within 0 and 1",
             o.tangential);
    if (o.iterations < 1 || o.iterations > 10000)
        fail(Status::invalid_argument, "registration: %d iterations, give 1 to 10000",
             o.iterations);
    if (o.start == StartKind::pose) {
        const Matrix3& r = o.pose.rotation;
        if (!r.allFinite() || !o.pose.translation.allFinite() || !(o.pose.scale > 0) ||
            !std::isfinite(o.pose.scale) ||
            (r * r.transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff() > 1e-3 ||
            r.determinant() < 0)
            fail(Status::invalid_argument,
                 "registration: the pose's rotation is not a rotation, or its numbers are not "
                 "finite");
    }
    if (o.scan_weights.size() != 0) {
        if (o.scan_weights.size() != scan.vertices.rows())
            fail(Status::mismatch, "registration: %lld scan weights for %lld scan vertices",
                 static_cast<long long>(o.scan_weights.size()),
                 static_cast<long long>(scan.vertices.rows()));
        for (Index i = 0; i < o.scan_weights.size(); ++i)
            if (!(o.scan_weights[i] >= 0 && o.scan_weights[i] <= 1))
                fail_at(Status::invalid_argument, i,
                        "registration: scan weight %lld is %g, outside 0 and 1",
                        static_cast<long long>(i), o.scan_weights[i]);
    }
}

// Pins in the order given; names the model does not know are returned aside.
std::vector<Pin> match_landmarks(const DeformationModel& model,
                                 const std::vector<LandmarkPoint>& landmarks, double unit,
                                 double sigma_mm, std::vector<std::string>& names,
                                 std::vector<std::string>& unknown) {
    std::vector<Pin> pins;
    for (const LandmarkPoint& point : landmarks) {
        if (!point.point.allFinite())
            fail(Status::invalid_argument, "landmark '%.60s' is not finite", point.name.c_str());
        const auto known = std::find_if(model.landmarks.begin(), model.landmarks.end(),
                                        [&](const Landmark& l) { return l.name == point.name; });
        if (known == model.landmarks.end()) {
            unknown.push_back(point.name);
            continue;
        }
        pins.push_back({static_cast<Index>(known->vertex), unit * point.point, sigma_mm});
        names.push_back(point.name);
    }
    return pins;
}

double choose_unit(const Points& vertices, UnitRule rule) {
    if (rule == UnitRule::millimetres) return 1;
    const double unit = detect_unit_mm(vertices);
    if (rule == UnitRule::refuse && unit != 1)
        fail(Status::invalid_argument,
             unit == 0 ? "the scan's size fits no head in mm, cm, dm, inches or metres"
                       : "the scan is not in millimetres: one unit seems to be %g mm; scale it or "
                         "let units be detected",
             unit);
    return unit == 0 ? 1 : unit;
}

// Share of places near the scan whose normals oppose it.
double opposed_share(const DeformationModel& model, const ScanSurface& scan, const Points& places,
                     const Context& context) {
    const Points normals = vertex_normals(places, model.template_mesh.triangles);
    std::vector<SurfaceHit> hits;
    scan.tree.closest(places, 10, hits, context);
    Index near = 0, opposed = 0;
    for (Index i = 0; i < places.rows(); ++i) {
        const SurfaceHit& hit = hits[static_cast<std::size_t>(i)];
        if (!hit.valid()) continue;
        const double cosine = normals.row(i).dot(scan.normal_at(hit).transpose());
        if (std::abs(cosine) < 0.3) continue;
        ++near;
        opposed += cosine < 0;
    }
    return near > 0 ? static_cast<double>(opposed) / static_cast<double>(near) : 0;
}

// Fills the verdict's measures from the finished fit.
void assess(const DeformationModel& model, const ScanSurface& scan, const std::vector<Pin>& pins,
            const FitState& state, RegistrationResult& result) {
    Verdict& v = result.verdict;
    const Index n = model.num_vertices();
    const double near = 3 * std::max(result.sigma_mm, 0.5);
    Index beside = 0, inliers = 0;
    double residual = 0;
    for (Index i = 0; i < n; ++i) {
        const SurfaceHit& hit = result.correspondence[static_cast<std::size_t>(i)];
        if (!hit.valid() || scan.at_border(hit) || hit.distance() > 10) continue;
        if (state.inner[static_cast<std::size_t>(i)]) continue;
        ++beside;
        if (hit.distance() > near || !(state.final_weight[i] > 0)) continue;
        ++inliers;
        residual += hit.distance();
    }
    v.coverage = static_cast<double>(beside) / static_cast<double>(n);
    v.inlier_share = beside > 0 ? static_cast<double>(inliers) / static_cast<double>(beside) : 0;
    v.mean_residual_mm = inliers > 0 ? residual / static_cast<double>(inliers) : 1e3;
    double squares = 0;
    for (const Pin& pin : pins)
        squares += (state.places.row(pin.vertex).transpose() - pin.place).squaredNorm();
    v.landmarks_used = static_cast<int>(pins.size());
    v.landmark_rms_mm = pins.empty() ? 0 : std::sqrt(squares / static_cast<double>(pins.size()));
    const auto spread = [](const Points& points) {
        const Eigen::RowVector3d mean = points.colwise().mean();
        return std::sqrt((points.rowwise() - mean).rowwise().squaredNorm().mean());
    };
    v.size_ratio = spread(state.places) / spread(model.template_mesh.vertices);
    const FitCoefficients& c = state.coefficients;
    double deviation = 0;
    if (c.pca.size() > 0)
        deviation = std::sqrt(c.pca.squaredNorm() / static_cast<double>(c.pca.size()));
    if (c.kernel.size() > 0)
        deviation = std::max<double>(
            deviation, std::sqrt(c.kernel.squaredNorm() / static_cast<double>(c.kernel.size())) /
                           state.kernel_amplitude);
    v.mean_deviation = deviation;
    v.may_slide = pins.size() < 3 && c.pca.size() == 0;
    judge(v, VerdictLimits());
}

}  // namespace

RegistrationResult register_scan(const DeformationModel& model, const TriMesh& raw_scan,
                                 const std::vector<LandmarkPoint>& landmarks,
                                 const RegistrationOptions& given, const Context& context) {
    check_options(given, raw_scan);
    const Index n = model.num_vertices();
    RegistrationOptions options = given;
    RegistrationResult result;
    context.progress(Stage::alignment, 0);

    // The scan: cleaned, in millimetres, weighted, in a tree.
    CleanedMesh cleaned = clean_mesh(raw_scan, CleaningOptions(), context);
    const double unit = choose_unit(cleaned.mesh.vertices, options.units);
    result.verdict.unit_to_mm = unit;
    cleaned.mesh.vertices *= unit;
    Vector scan_weight;
    if (options.scan_weights.size() > 0 || options.skin_weights) {
        scan_weight.setOnes(cleaned.mesh.vertices.rows());
        if (options.skin_weights && cleaned.mesh.colors.rows() == scan_weight.size())
            scan_weight = skin_weights(cleaned.mesh.colors, 0.05);
        if (options.scan_weights.size() > 0)
            for (Index i = 0; i < scan_weight.size(); ++i)
                scan_weight[i] *=
                    options.scan_weights[cleaned.vertex_to_old[static_cast<std::size_t>(i)]];
    }
    ScanSurface scan = prepare_scan(cleaned.mesh, options.normal_smoothing_mm, context);
    context.progress(Stage::alignment, 0.1);

    // The prior.
    FitState state;
    const Index p = options.max_pca_modes >= 0
                        ? std::min(options.max_pca_modes, model.pca_modes.cols)
                        : model.pca_modes.cols;
    Index r = options.max_scalar_modes >= 0 ? std::min(options.max_scalar_modes, model.basis.cols)
                                            : model.basis.cols;
    if (options.estimate_scale < 0) options.estimate_scale = p > 0 ? 0 : 1;
    state.kernel_amplitude = options.kernel_amplitude > 0 ? options.kernel_amplitude : 1;
    if (p > 0 && r > 0) {
        r = std::min(r, options.max_residual_modes);
        const double deviation =
            std::sqrt(static_cast<double>(model.basis.map().leftCols(r).squaredNorm()) /
                      static_cast<double>(n));
        if (!(options.kernel_amplitude > 0))
            state.kernel_amplitude = options.residual_sd_mm / std::max(deviation, 1e-9);
    }
    state.coefficients.kernel.setZero(r, 3);
    state.coefficients.pca.setZero(p);
    state.inner = find_inner_vertices(model.template_mesh, context);
    const ColorFeatures colors =
        options.color_features
            ? ColorFeatures(model, state.inner, scan, scan_weight, cleaned.mesh.colors, context)
            : ColorFeatures();
    if (!colors.empty()) state.colors = &colors;

    // The start.
    std::vector<std::string> names;
    std::vector<Pin> pins = match_landmarks(model, landmarks, unit, options.landmark_sigma_mm,
                                            names, result.unknown_landmarks);
    StartKind start = options.start;
    if (start == StartKind::automatic)
        start = pins.size() >= 3 ? StartKind::landmarks : StartKind::search;
    if (start == StartKind::landmarks) {
        if (pins.size() < 3)
            fail(Status::not_found,
                 "%lld of %lld landmarks are known to the model, at least 3 are needed",
                 static_cast<long long>(pins.size()), static_cast<long long>(landmarks.size()));
        state.motion = align_robustly(model, pins, options.estimate_scale != 0);
    } else if (start == StartKind::pose) {
        state.motion = options.pose;
    } else {
        SearchResult found = search_pose(model, scan, context);
        if (found.score < kGoodSearch) {  // perhaps its triangles face inwards
            scan.turn_over();
            const SearchResult turned = search_pose(model, scan, context);
            if (turned.score > found.score + 0.05)
                found = turned;
            else
                scan.turn_over();
        }
        result.verdict.search_score = found.score;
        state.motion = found.motion;
    }
    result.start = state.motion;
    const double pca_amplitude =
        p > 0 ? options.pca_amplitude : 0;  // modes left out say nothing of the landmarks
    if (!pins.empty()) {
        if (!(options.kernel_amplitude > 0)) {
            const PinEvidence likeliest =
                weigh_pins(model, pins, state.motion, state.kernel_amplitude, pca_amplitude);
            state.kernel_amplitude *= likeliest.amplitude;
            for (Pin& pin : pins) pin.sigma_mm *= likeliest.noise;
            context.log(LogLevel::debug, "kernel amplitude %.3f, picking error times %.2f",
                        state.kernel_amplitude, likeliest.noise);
        }
        std::vector<std::size_t> rejected =
            contradicting_pins(model, pins, state.motion, state.kernel_amplitude, pca_amplitude);
        std::sort(rejected.rbegin(), rejected.rend());
        for (const std::size_t k : rejected) {
            result.verdict.landmarks_rejected.push_back(names[k]);
            pins.erase(pins.begin() + static_cast<std::ptrdiff_t>(k));
        }
        if (!rejected.empty() && pins.size() >= 3 && start == StartKind::landmarks)
            state.motion = align_robustly(model, pins, options.estimate_scale != 0);
        if (pins.size() >= 3) fit_pins(model, pins, options, state, context);
    }
    context.progress(Stage::alignment, 0.9);
    if (start != StartKind::search) {
        const Points rest = model.template_mesh.vertices;
        const Points shaped =
            state.places.rows() == n ? state.places : Points(state.motion.apply(PointsRef(rest)));
        if (opposed_share(model, scan, shaped, context) > 0.6) scan.turn_over();
    }
    std::vector<Pin> held = pins;
    if (pins.size() < 3) {
        start_freely(model, scan, scan_weight, options, state, context);
        const std::vector<Pin> lids =
            shut_lids(model, scan, state, options.landmark_sigma_mm, context);
        held.insert(held.end(), lids.begin(), lids.end());
        options.data_weight = options.free_data_weight;
        options.color_weight = options.free_color_weight;
    }
    context.progress(Stage::alignment, 1);

    // The fit, and what the modes leave open.
    fit_surface(model, scan, scan_weight, held, options, state, context);
    result.sigma_mm = state.sigma_mm;
    const Triangles& triangles = model.template_mesh.triangles;
    const VertexRings rings = build_rings(n, triangles);
    const Points rest = state.motion.apply(PointsRef(model.template_mesh.vertices));
    Index repaired = 0, turned = 0;
    Vector closed;  // weights of the last stage
    if (options.close_gap) {
        GapOptions gap;
        gap.smoothness = options.gap_smoothness;
        gap.robust_scale_mm = 2 * options.sigma_end_mm;
        const Points before = state.places;
        Vector open(n);
        for (Index i = 0; i < n; ++i) open[i] = state.inner[static_cast<std::size_t>(i)] ? 0 : 1;
        closed = close_gap(scan, scan_weight, triangles, rings, open, options.correspondence, gap,
                           state.places, context);
        if (options.repair) repaired = undo_turns(before, triangles, rings, state.places);
    }
    // What trained modes fold, faces have been seen to fold: only the rest has to lie as the
    // template does.
    const Points form = state.motion.apply(
        PointsRef(model.template_mesh.vertices +
                  displacement(model, {Matrix(), state.coefficients.pca.cast<double>()}, context)));
    carry_inner(model.template_mesh, rings, form, state.inner, state.places, context);
    Index left = static_cast<Index>(
        find_turned(form, triangles, rings, state.places, options.max_turn_rad).size());
    if (options.repair)
        left = straighten_turned(form, triangles, rings, options.max_turn_rad, 12, state.places,
                                 turned);
    result.verdict.repaired_triangles = static_cast<int>(repaired + turned - left);
    result.verdict.flipped_triangles = static_cast<int>(left);

    // What the host gets.
    const Points normals = vertex_normals(state.places, triangles);
    const Points normals_model = normals * state.motion.rotation;
    // Where the modes could not follow, the place along the skin is not known, though the surface
    // is.
    result.confidence_mm =
        place_deviation(model, state, state.final_weight, normals_model, pins, options, context);
    result.weight =
        closed.size() > 0 ? Vector(state.final_weight.cwiseMax(closed)) : state.final_weight;
    scan.tree.closest(state.places, 1e30, result.correspondence, context);
    result.residual_mm.resize(n);
    for (Index i = 0; i < n; ++i) {
        SurfaceHit& hit = result.correspondence[static_cast<std::size_t>(i)];
        if (!hit.valid())  // farther than any distance: an absurd start pose, or a fit that blew up
            fail_at(Status::no_solution, i,
                    "registration: the fit ended beyond reach of the scan; check the start pose "
                    "and the unit");
        const double side = normals.row(i).dot(hit.point.transpose() - state.places.row(i));
        result.residual_mm[i] = side < 0 ? -hit.distance() : hit.distance();
    }
    result.energy = state.energy;
    result.motion = state.motion;
    result.iterations = state.iterations;
    result.verdict.self_intersections =
        static_cast<int>(count_self_intersections(state.places, triangles, context));
    if (state.colors)
        result.verdict.colors =
            colors.agreements(state.places, normals, options.correspondence, context);
    assess(model, scan, pins, state, result);
    for (SurfaceHit& hit : result.correspondence)  // numbers of the scan as it was given
        hit.triangle = scan.tree.is_point_cloud() ? cleaned.vertex_to_old[hit.triangle]
                                                  : cleaned.triangle_to_old[hit.triangle];
    result.fitted.vertices = state.places;
    result.fitted.triangles = triangles;
    result.fitted.texture = model.template_mesh.texture;
    result.fitted.texture_triangles = model.template_mesh.texture_triangles;
    return result;
}

}  // namespace mien
