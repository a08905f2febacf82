#include "registration/registration.hpp"

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
    const PreparedScan scan = prepare_scan(raw, settings.intake, context);
    context.progress(Stage::alignment, 0.1);
    const PriorState prior =
        choose_prior(model, settings.prior, settings.inner, settings.colors, context);
    return register_prepared(model, scan, prior, landmarks, settings, context);
}

}  // namespace mien
