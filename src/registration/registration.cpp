#include "registration/registration.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "geometry/normals.hpp"
#include "mesh/length_unit.hpp"
#include "registration/output.hpp"
#include "registration/ready_scan.hpp"
#include "registration/trained_span.hpp"

namespace mien {
namespace {

struct BeginAndFit {
    StartState start;
    FitOutcome fit;
};

// The start anew after a fit, by another prior; a pose that was searched is kept, and what was
// noted.
StartState start_again(const DeformationModel& model, const PreparedScan& scan,
                       const PriorState& prior, const std::vector<LandmarkPoint>& landmarks,
                       const RegistrationSettings& settings, const StartState& before,
                       const Context& quiet) {
    StartSettings again = settings.start;
    if (before.searched) {
        again.kind = StartKind::pose;
        again.pose = before.motion;
    }
    StartState start = find_start(model, scan, prior, landmarks, again, settings.fit.loop, quiet);
    start.searched = before.searched;
    start.search_score = before.search_score;
    for (const std::string& note : before.notes)
        if (std::find(start.notes.begin(), start.notes.end(), note) == start.notes.end())
            start.notes.push_back(note);
    return start;
}

// Landmarks that all lie to one side of the fitted face are moved back onto it, as far as further
// fits show; what they lie off by is told.
void mend_shifted_landmarks(const DeformationModel& model, const PreparedScan& scan,
                            std::vector<LandmarkPoint>& landmarks,
                            const RegistrationSettings& settings, const PriorState& prior,
                            BeginAndFit& done, const Context& context) {
    const ShiftedLandmarkSettings& rules = settings.shifted;
    if (!rules.mend) return;
    const std::optional<Misfit> found =
        common_misfit(done.start.pins, done.fit.state.places, rules);
    if (!found) return;
    Context quiet = context;
    quiet.progress_function = nullptr;
    ShiftSearch search(*found, rules);
    std::optional<BeginAndFit> best;
    std::vector<LandmarkPoint> mended;
    Vector3 shift_mm = Vector3::Zero();
    for (int k = 0; k < rules.most_fits && !search.settled(); ++k) {
        const Vector3 tried = search.shift();
        std::vector<LandmarkPoint> moved = landmarks;
        for (LandmarkPoint& landmark : moved) landmark.point -= tried / scan.unit_to_mm;
        BeginAndFit anew{start_again(model, scan, prior, moved, settings, done.start, quiet), {}};
        if (anew.start.pins.empty()) break;
        anew.fit = fit_surface(model, prior, anew.start, settings.fit, quiet);
        if (!search.take(misfit_of(anew.start.pins, anew.fit.state.places))) continue;
        shift_mm = tried;
        mended = std::move(moved);
        best = std::move(anew);
    }
    if (!best) return;
    landmarks = std::move(mended);
    done = std::move(*best);
    char note[300];
    std::snprintf(note, sizeof note,
                  "the landmarks lie %.1f mm from the face, all to one side: they were moved back "
                  "by that; were they picked on this scan, and in its frame?",
                  shift_mm.norm());
    done.start.notes.emplace_back(note);
}

// By the kernel alone, where that leaves clearly less of the surface open than the finished fit by
// trained modes does.
void leave_trained_modes_out(const DeformationModel& model, const PreparedScan& scan,
                             const std::vector<LandmarkPoint>& landmarks,
                             const RegistrationSettings& settings, PriorState& prior,
                             BeginAndFit& done, const Context& context) {
    if (!done.start.is_free() || !may_weigh_trained(model, prior, settings.span)) return;
    const auto open = [&](const BeginAndFit& fitted, const PriorState& by) {
        return open_surface(model, by, fitted.start, fitted.fit, settings.fit.loop.match,
                            settings.span, context);
    };
    const OpenSurface by_trained = open(done, prior);
    if (!(by_trained.middle_mm > settings.span.least_open_mm)) return;
    Context quiet = context;
    quiet.progress_function = nullptr;
    const PriorState alone = kernel_alone(model, prior, settings.prior);
    BeginAndFit anew{start_again(model, scan, alone, landmarks, settings, done.start, quiet), {}};
    anew.fit = fit_surface(model, alone, anew.start, settings.fit, quiet);
    const OpenSurface by_kernel = open(anew, alone);
    context.log(LogLevel::debug, "trained modes leave %.3f mm open, the kernel alone %.3f mm",
                by_trained.middle_mm, by_kernel.middle_mm);
    if (!surface_prefers_kernel(by_trained, by_kernel, settings.span)) return;
    anew.start.notes.emplace_back(
        "by its surface the face is outside of what the trained modes span: fitted by the kernel "
        "alone");
    prior = alone;
    done = std::move(anew);
}

// The features that led the finished fit astray are left out, and all begins anew without them; a
// pose that was searched is kept.
bool leave_lying_colors_out(const DeformationModel& model, const PreparedScan& scan,
                            const std::vector<LandmarkPoint>& landmarks,
                            const RegistrationSettings& settings, PriorState& prior,
                            BeginAndFit& done, const Context& context) {
    if (prior.colors.empty() || !scan.surface.has_colors()) return false;
    const LoopSettings& loop = settings.fit.loop;
    const Points normals = vertex_normals(done.fit.state.places, model.template_mesh.triangles);
    const std::vector<std::string> lying = prior.colors.lying(prior.colors.agreements(
        done.start.scan, done.fit.state.places, normals, loop.match, context));
    if (lying.empty()) return false;
    prior.colors = prior.colors.without(lying);
    Context quiet = context;
    quiet.progress_function = nullptr;
    if (done.start.is_free())
        done.start = start_again(model, scan, prior, landmarks, settings, done.start, quiet);
    done.start.colors_left_out = lying;
    done.fit = fit_surface(model, prior, done.start, settings.fit, quiet);
    return true;
}

}  // namespace

RegistrationResult register_prepared(const DeformationModel& model, const PreparedScan& scan,
                                     const PriorState& prior,
                                     const std::vector<LandmarkPoint>& given,
                                     const RegistrationSettings& settings, const Context& context) {
    check_settings(settings);
    std::vector<LandmarkPoint> landmarks = given;
    const VertexRings rings = build_rings(model.num_vertices(), model.template_mesh.triangles);
    const LoopSettings& loop = settings.fit.loop;
    BeginAndFit done{find_start(model, scan, prior, landmarks, settings.start, loop, context), {}};
    PriorState settled = prior;
    if (landmarks_prefer_kernel(model, prior, done.start, settings.start.landmark_sigma_mm,
                                settings.start.pin_prior, settings.span, context)) {
        settled = kernel_alone(model, prior, settings.prior);
        done.start = find_start(model, scan, settled, landmarks, settings.start, loop, context);
        done.start.notes.emplace_back(
            "by its landmarks the face is outside of what the trained modes span: fitted by the "
            "kernel alone");
    }
    done.fit = fit_surface(model, settled, done.start, settings.fit, context);
    mend_shifted_landmarks(model, scan, landmarks, settings, settled, done, context);
    leave_trained_modes_out(model, scan, landmarks, settings, settled, done, context);
    leave_lying_colors_out(model, scan, landmarks, settings, settled, done, context);
    const StartState& start = done.start;
    const FitOutcome& fit = done.fit;
    const GapState gap = close_gap(model, start.scan, settled, fit.state, rings, loop.match,
                                   loop.sigma_end_mm, settings.gap, context);
    const InnerPartsState inner = settle_inner_parts(model, settled, fit.state, rings, gap.places,
                                                     settings.inner, settings.folds, context);
    return make_result({model, scan, settled, start, fit, gap, inner}, settings, context);
}

namespace {

// A face was found in no known unit: whatever has a size is a guess.
void doubt_unit(Verdict& verdict) {
    if (verdict.quality == FitQuality::good) verdict.quality = FitQuality::doubtful;
    doubt_zones(verdict);
    char reason[300];
    std::snprintf(
        reason, sizeof reason,
        "no known unit fits the scan: one unit was taken for %.4g mm, as if the face were "
        "as large as the template; lengths and volumes are a guess until the unit is "
        "given or the scan is scaled to mm",
        verdict.unit_to_mm);
    verdict.reasons.emplace_back(reason);
}

// No face where one was expected: perhaps one of another size, as in a body in centimetres.
void try_other_units(const DeformationModel& model, const TriMesh& raw, const PriorState& prior,
                     const std::vector<LandmarkPoint>& landmarks, double extent,
                     IntakeSettings intake, const RegistrationSettings& settings,
                     RegistrationResult& result, const Context& quiet) {
    const double tried_mm = result.verdict.unit_to_mm;
    for (const LengthUnit& unit : plausible_units(extent)) {
        if (unit.to_mm == tried_mm) continue;
        intake.unit_to_mm = unit.to_mm;
        RegistrationResult other = register_prepared(model, prepare_scan(raw, intake, quiet), prior,
                                                     landmarks, settings, quiet);
        if (other.verdict.search_score >
            result.verdict.search_score + settings.start.search.turned_by)
            result = std::move(other);
    }
}

// The unit, of any size, in which a face is found best; 0 when it is in none.
double guess_unit_mm(const DeformationModel& model, const TriMesh& raw, double extent,
                     IntakeSettings intake, const RegistrationSettings& settings,
                     const Context& quiet) {
    const GuessSettings& guess = settings.guess;
    double best_mm = 0, best_score = guess.sure;
    const auto attempt = [&](double unit_mm) {
        intake.unit_to_mm = unit_mm;
        const PreparedScan scan = prepare_scan(raw, intake, quiet);
        ScanView view(scan.surface);
        const double score = search_pose_and_side(model, view, settings.start.search, quiet).score;
        if (score <= best_score) return;
        best_score = score;
        best_mm = unit_mm;
    };
    for (double size_mm = guess.smallest_mm; size_mm <= guess.largest_mm; size_mm *= guess.step)
        attempt(size_mm / extent);
    if (best_mm == 0) return 0;
    const double middle_mm = best_mm, half_step = std::pow(guess.step, 1 / 3.0);
    attempt(middle_mm / half_step);
    attempt(middle_mm * half_step);
    return best_mm;
}

// A scan of raw coordinates, all in their unit, that may have been moved by -origin.
RegistrationResult register_in_frame(const DeformationModel& model, const TriMesh& raw,
                                     const LandmarkFrame& frame, const Vector3& origin,
                                     const RegistrationSettings& given, const Context& context) {
    RegistrationSettings settings = given;
    IntakeSettings& intake = settings.intake;
    const std::vector<LandmarkPoint>& landmarks = frame.landmarks;
    if (frame.settled && intake.units != UnitRule::refuse) intake.unit_to_mm = frame.scan_to_mm;
    const PreparedScan scan = prepare_scan(raw, intake, context);
    settings.start.pose.translation -= scan.unit_to_mm * origin;
    context.progress(Stage::alignment, 0.1);
    const PriorState prior =
        choose_prior(model, settings.prior, settings.inner, settings.colors, context);
    RegistrationResult result = register_prepared(model, scan, prior, landmarks, settings, context);
    if (const std::string note = describe(frame); !note.empty())
        result.verdict.notes.push_back(note);
    if (frame.unit_guessed) doubt_unit(result.verdict);
    const double least_score = settings.verdict.limits.doubtful_search;
    const auto no_face = [&] {
        return result.verdict.searched && result.verdict.search_score < least_score;
    };
    if (intake.unit_to_mm > 0 || intake.units != UnitRule::detect || !no_face()) return result;
    Context quiet = context;
    quiet.progress_function = nullptr;
    const double extent = robust_extent(scan.surface.vertices) / scan.unit_to_mm;
    try_other_units(model, raw, prior, landmarks, extent, intake, settings, result, quiet);
    // What is as large as a head in millimetres is in millimetres, face or not.
    if (!settings.guess.enabled || scan.unit_to_mm == 1 || !no_face()) return result;
    intake.unit_to_mm = guess_unit_mm(model, raw, extent, intake, settings, quiet);
    if (!(intake.unit_to_mm > 0)) return result;
    result = register_prepared(model, prepare_scan(raw, intake, quiet), prior, landmarks, settings,
                               quiet);
    doubt_unit(result.verdict);
    return result;
}

}  // namespace

RegistrationResult register_scan(const DeformationModel& model, const TriMesh& raw,
                                 const std::vector<LandmarkPoint>& landmarks,
                                 const RegistrationSettings& settings, const Context& context) {
    check_settings(settings);
    context.progress(Stage::alignment, 0);
    const IntakeSettings& intake = settings.intake;
    const double known_mm = intake.unit_to_mm > 0                   ? intake.unit_to_mm
                            : intake.units == UnitRule::millimetres ? 1.0
                                                                    : 0.0;
    LandmarkFrame frame = settle_landmark_frame(model, raw.vertices, landmarks, known_mm,
                                                settings.frame, intake.unit);
    const Vector3 origin = far_origin(raw.vertices, settings.far);
    if (origin.isZero()) return register_in_frame(model, raw, frame, origin, settings, context);
    TriMesh near = raw;
    near.vertices.rowwise() -= origin.transpose();
    for (LandmarkPoint& landmark : frame.landmarks) landmark.point -= origin;
    RegistrationResult result = register_in_frame(model, near, frame, origin, settings, context);
    move_result(result.verdict.unit_to_mm * origin, result);
    return result;
}

}  // namespace mien
