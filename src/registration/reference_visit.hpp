// A registration that is tied to an earlier visit's by texture: from what a host has of two visits
// (the scans as they were given, the fits that were made of them) to a fit that holds the moved
// places and says how they are held.
#pragma once

#include "registration/registration.hpp"
#include "registration/texture_tie.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct ReferenceSettings {
    TextureTieSettings tie;
    double fine_texel = 0.7;    ///< > 0, pixels of the views: finer texels are averaged [J]
    double beside_mm = 3;       ///< mm, > 0: a fit's place so near lies on its scan [J]
    double least_beside = 0.3;  ///< 0 to 1: of the places that the scan counted for, or it is
                                ///< another scan [J]
};

/// Throws Status::invalid_argument, naming the member and its range.
void check_reference_settings(const ReferenceSettings& settings);

/// What is kept of a visit. Borrowed.
struct KeptVisit {
    const TriMesh& fitted;          ///< template topology, the scan's frame, mm
    const RegistrationResult& fit;  ///< weights, deviations, unit; perhaps of a record
    const TriMesh& scan;            ///< as it was given to the registration, any unit
};

struct TiedVisit {
    RegistrationResult fit;  ///< of the visit: residuals and correspondence anew, a note; where the
                             ///< texture holds a place its deviation is the reference's
    TextureTie tie;
};

/// Both visits are fits of `model`. Throws Status::mismatch for fits of another template and for a
/// scan that does not lie under its fit, invalid_argument for a scan without colours or settings
/// out of range, and what prepare_scan() and tie_by_texture() throw. One to three seconds.
TiedVisit tie_to_reference(const DeformationModel& model, const KeptVisit& reference,
                           const KeptVisit& visit, const ReferenceSettings& settings,
                           const Context& context);

/// The tie as a JSON object: tied, why_not, shares, and of each zone how far the texture holds it.
std::string tie_json(const TextureTie& tie, const std::vector<Zone>& zones);

}  // namespace mien
