// A fit that is kept: everything a study needs of a registration, as one safetensors file, so that
// visits can be fitted today and studied in a year.
//
// safetensors, kind "mien-fit-record", format 1. Places, residuals, weights and deviations are
// float64: what is read again gives the same bits as the registration itself. The model's zones
// stand in it, the scan does not; places on the scan are kept as triangles with barycentric
// coordinates.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/safetensors.hpp"
#include "registration/registration.hpp"

namespace mien {

struct TextureTie;

struct FitRecord {
    TriMesh mesh;                           ///< the fitted template; fit.fitted stays empty
    RegistrationResult fit;                 ///< `correspondence` without points and distances
    std::vector<Zone> zones;                ///< of the model, on its template
    std::shared_ptr<const TextureTie> tie;  ///< without `places`; null: never tied
};

/// Writes atomically; `tie` may be null. Throws Status::io.
void save_fit_record(const std::string& path, const TriMesh& mesh, const RegistrationResult& fit,
                     const std::vector<Zone>& zones, const TextureTie* tie, const Context& context);

/// Errors of SafetensorsFile; Status::bad_format or corrupt for numbers that are no fit, naming the
/// tensor.
FitRecord load_fit_record(const std::string& path, const Context& context);
FitRecord read_fit_record(const SafetensorsFile& file);

/// A record of a face that was fitted elsewhere, or whose arrays a host kept itself: #V weights in
/// [0, 1], signed residuals and deviations of the place per axis in mm; each may be empty: not
/// known. Throws Status::mismatch for
/// arrays of another length than the mesh and invalid_argument for values out of range.
FitRecord fit_record_of(TriMesh mesh, Vector weights, Vector residual_mm, Vector place_sd_mm,
                        FitQuality quality, std::vector<Zone> zones);

}  // namespace mien
