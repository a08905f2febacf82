#include "registration/registration.hpp"

#include "mesh/length_unit.hpp"
#include "registration/output.hpp"

namespace mien {

RegistrationResult register_prepared(const DeformationModel& model, const PreparedScan& scan,
                                     const PriorState& prior,
                                     const std::vector<LandmarkPoint>& landmarks,
                                     const RegistrationSettings& settings, const Context& context) {
    check_settings(settings);
    const VertexRings rings = build_rings(model.num_vertices(), model.template_mesh.triangles);
    const LoopSettings& loop = settings.fit.loop;
    const StartState start =
        find_start(model, scan, prior, landmarks, settings.start, loop, context);
    const FitOutcome fit = fit_surface(model, prior, start, settings.fit, context);
    const GapState gap = close_gap(model, start.scan, prior, fit.state, rings, loop.match,
                                   loop.sigma_end_mm, settings.gap, context);
    const InnerPartsState inner = settle_inner_parts(model, prior, fit.state, rings, gap.places,
                                                     settings.inner, settings.folds, context);
    return make_result({model, scan, prior, start, fit, gap, inner}, settings, context);
}

RegistrationResult register_scan(const DeformationModel& model, const TriMesh& raw,
                                 const std::vector<LandmarkPoint>& landmarks,
                                 const RegistrationSettings& settings, const Context& context) {
    check_settings(settings);
    context.progress(Stage::alignment, 0);
    IntakeSettings intake = settings.intake;
    const double known_mm = intake.unit_to_mm > 0                   ? intake.unit_to_mm
                            : intake.units == UnitRule::millimetres ? 1.0
                                                                    : 0.0;
    const LandmarkFrame frame =
        settle_landmark_frame(model, raw.vertices, landmarks, known_mm, settings.frame);
    if (frame.settled && intake.units != UnitRule::refuse) intake.unit_to_mm = frame.scan_to_mm;
    const PreparedScan scan = prepare_scan(raw, intake, context);
    context.progress(Stage::alignment, 0.1);
    const PriorState prior =
        choose_prior(model, settings.prior, settings.inner, settings.colors, context);
    RegistrationResult result =
        register_prepared(model, scan, prior, frame.landmarks, settings, context);
    if (const std::string note = describe(frame); !note.empty())
        result.verdict.notes.push_back(note);
    if (intake.unit_to_mm > 0 || intake.units != UnitRule::detect || !result.verdict.searched ||
        result.verdict.search_score >= settings.verdict.limits.doubtful_search)
        return result;
    // No face where a face was expected: perhaps one of another size, as in a body in centimetres.
    Context quiet = context;
    quiet.progress_function = nullptr;
    const double extent = robust_extent(scan.surface.vertices) / scan.unit_to_mm;
    for (const LengthUnit& unit : plausible_units(extent)) {
        if (unit.to_mm == scan.unit_to_mm) continue;
        intake.unit_to_mm = unit.to_mm;
        RegistrationResult other = register_prepared(model, prepare_scan(raw, intake, quiet), prior,
                                                     landmarks, settings, quiet);
        if (other.verdict.search_score >
            result.verdict.search_score + settings.start.search.turned_by)
            result = std::move(other);
    }
    return result;
}

}  // namespace mien
