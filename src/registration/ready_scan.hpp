// A scan that was prepared once, for fits of several models or with other settings and landmarks.
#pragma once

#include "registration/registration.hpp"

namespace mien {

/// Immutable; safe to share between threads and fits.
struct ReadyScan {
    PreparedScan scan;
    Vector3 origin = Vector3::Zero();  ///< in the scan's unit: a far scan was moved near by it
};

/// The unit is that of the settings, or told by size: no face is looked for. As prepare_scan().
ReadyScan make_ready(const TriMesh& raw, const IntakeSettings& settings, const FarScanSettings& far,
                     const Context& context);

/// register_scan() of it (settings.intake is not read, and no other unit is tried). `landmarks` in
/// the raw scan's frame, in its or another known unit; results are in the raw scan's frame, mm.
RegistrationResult register_ready(const DeformationModel& model, const ReadyScan& ready,
                                  const std::vector<LandmarkPoint>& landmarks,
                                  const RegistrationSettings& settings, const Context& context);

/// Moves all places of a result.
void move_result(const Vector3& by_mm, RegistrationResult& result);

}  // namespace mien
