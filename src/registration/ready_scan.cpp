#include "registration/ready_scan.hpp"

namespace mien {

void move_result(const Vector3& by_mm, RegistrationResult& result) {
    result.fitted.vertices.rowwise() += by_mm.transpose();
    for (SurfaceHit& hit : result.correspondence) hit.point += by_mm;
    result.start.translation += by_mm;
    result.motion.translation += by_mm;
}

ReadyScan make_ready(const TriMesh& raw, const IntakeSettings& settings, const FarScanSettings& far,
                     const Context& context) {
    context.progress(Stage::alignment, 0.01);
    ReadyScan ready;
    ready.origin = far_origin(raw.vertices, far);
    const bool is_far = !ready.origin.isZero();
    TriMesh near;  // only scans far from their origin are copied
    if (is_far) {
        near = raw;
        near.vertices.rowwise() -= ready.origin.transpose();
    }
    ready.scan = prepare_scan(is_far ? near : raw, settings, context);
    context.progress(Stage::alignment, 1);
    return ready;
}

RegistrationResult register_ready(const DeformationModel& model, const ReadyScan& ready,
                                  const std::vector<LandmarkPoint>& landmarks,
                                  const RegistrationSettings& given, const Context& context) {
    check_settings(given);
    context.progress(Stage::alignment, 0);
    const double unit_to_mm = ready.scan.unit_to_mm;
    const Points raw =
        (ready.scan.surface.vertices / unit_to_mm).rowwise() + ready.origin.transpose();
    LandmarkFrame frame =
        settle_landmark_frame(model, raw, landmarks, unit_to_mm, given.frame, given.intake.unit);
    for (LandmarkPoint& landmark : frame.landmarks) landmark.point -= ready.origin;
    RegistrationSettings settings = given;
    settings.start.pose.translation -= unit_to_mm * ready.origin;
    const PriorState prior =
        choose_prior(model, settings.prior, settings.inner, settings.colors, context);
    RegistrationResult result =
        register_prepared(model, ready.scan, prior, frame.landmarks, settings, context);
    if (const std::string note = describe(frame); !note.empty())
        result.verdict.notes.push_back(note);
    if (!ready.origin.isZero()) move_result(unit_to_mm * ready.origin, result);
    return result;
}

}  // namespace mien
