#include "registration/trained_span.hpp"

#include <cmath>

#include "base/median.hpp"
#include "geometry/normals.hpp"
#include "model/landmarks.hpp"

namespace mien {

bool may_weigh_trained(const DeformationModel& model, const PriorState& prior,
                       const TrainedSpanSettings& settings) {
    return settings.weigh && prior.pca_modes > 0 && !prior.amplitude_given && model.basis.cols > 0;
}

OpenSurface open_surface(const DeformationModel& model, const PriorState& prior,
                         const StartState& start, const FitOutcome& fit,
                         const CorrespondenceSettings& match, const TrainedSpanSettings& settings,
                         const Context& context) {
    const Points& places = fit.state.places;
    Correspondences found;
    find_correspondences(start.scan, places, vertex_normals(places, model.template_mesh.triangles),
                         match, found, context, prior.inner);
    const Zone* face = find_zone(model.zones, "face");
    std::vector<double> open_mm;
    const auto look_at = [&](Index i) {
        if (found.weight[i] < settings.least_weight) return;
        const Vector3 off =
            found.hits[static_cast<std::size_t>(i)].point - places.row(i).transpose();
        open_mm.push_back(std::abs(found.normals.row(i).dot(off)));
    };
    if (face != nullptr)
        for (const std::uint32_t v : face->vertices) look_at(static_cast<Index>(v));
    else
        for (Index i = 0; i < places.rows(); ++i) look_at(i);
    if (open_mm.empty()) return {};
    const Index seen = static_cast<Index>(open_mm.size());
    return {median(std::move(open_mm)), seen};
}

bool surface_prefers_kernel(const OpenSurface& trained, const OpenSurface& kernel,
                            const TrainedSpanSettings& settings) {
    return static_cast<double>(kernel.seen) >=
               settings.least_seen * static_cast<double>(trained.seen) &&
           kernel.middle_mm < settings.kernel_share * trained.middle_mm;
}

bool landmarks_prefer_kernel(const DeformationModel& model, const PriorState& prior,
                             const StartState& start, double landmark_sigma_mm,
                             const PinPriorSettings& pins, const TrainedSpanSettings& settings,
                             const Context& context) {
    if (!may_weigh_trained(model, prior, settings) || !start.pin_factors.weighed) return false;
    std::vector<Pin> stated = start.pins;
    for (Pin& pin : stated) pin.sigma_mm = landmark_sigma_mm;
    const PinFactors alone = weigh_pins(model, stated, start.motion, 1, 0, pins, context);
    return alone.weighed && alone.cost + settings.clearly < start.pin_factors.cost;
}

}  // namespace mien
