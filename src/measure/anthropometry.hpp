// The measurements of anthropometry_table.hpp on one face, each with its deviation.
//
// Deviation, to first order: a measurement m of places x_i moves by sum_i g_i . e_i, g_i = dm/dx_i.
// A fitted template errs along the skin and across it differently: with the normal n_i, deviations
// s_n (along it) and s_t (per direction of the tangent plane), and correlations rho that fall with
// the distance of the places as exp(-d^2 / (2 l^2)),
//     Var m = sum_ij rho_n g_i.n_i g_j.n_j s_n,i s_n,j + rho_t (T_i g_i).(T_j g_j) s_t,i s_t,j,
// T = I - n n'. The place's deviation per axis, s, is a root mean square over three axes, so
// s_t^2 = (3 s^2 - s_n^2) / 2. A surface length also has its method's error (heat method). What is
// not in it: how well the template's landmark stands for the field's, and two observers'
// difference.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/context.hpp"
#include "geometry/surface_errors.hpp"
#include "measure/anthropometry_table.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// A named place of a face: a vertex, or a point (picked on a scan) that belongs to none.
struct FacePlace {
    std::string name;
    std::int64_t vertex = -1;         ///< -1: `point` counts
    Vector3 point = Vector3::Zero();  ///< mm
};

struct AnthropometryErrors {
    Vector place_sd_mm;   ///< #V, of the place, per axis; empty: not known, and no deviation
    Vector normal_sd_mm;  ///< #V, along the normal; empty: as place_sd_mm
    /// Over which a template slides together along the skin, and errs together across it, mm, >= 0.
    double slide_correlation_mm = 15.0;  ///< as SurfaceErrorSettings: the kernels' reach
    double normal_correlation_mm = kSurfaceCorrelationMm;
};

struct AnthropometricValue {
    const AnthropometricDefinition* definition = nullptr;
    double value;        ///< in unit_of(definition->kind); not a number: see `reason`
    double sd;           ///< of `value`; not a number where the places' errors are not known
    std::string reason;  ///< why there is no value, in words; empty otherwise
};

/// One value per definition, in the table's order. Names of places are matched with the table's
/// names, abbreviations ("prn", "ch_left", "left_cheilion") and the 68-point names, whatever their
/// case and separators; the field's own names come first. Throws Status::invalid_mesh for a damaged
/// surface, Status::mismatch for a vertex that is not there or deviations of another length,
/// Status::invalid_argument for deviations below zero, points or lengths that are not finite. One
/// factorisation, O(#V^1.5), when a surface length is known.
std::vector<AnthropometricValue> measure_anthropometry(const TriMesh& face,
                                                       const std::vector<FacePlace>& places,
                                                       const AnthropometryErrors& errors,
                                                       const Context& context);

/// Where a landmark of the field lies on a face: a mean of places. `from` names what it was read
/// from; empty: the face has no such landmark.
struct AnatomicalPlace {
    std::vector<std::size_t> places;  ///< one or two, indices
    std::string from;
};
/// One per anatomical_landmarks(), in the table's order.
std::vector<AnatomicalPlace> find_anatomical_places(const std::vector<FacePlace>& places);

class NormSet;  // norms.hpp
/// UTF-8: {"anthropometry": {"measurements": [...], "landmarks": {name: from}}}; what is not known
/// is null. norms: null for none.
std::string anthropometry_json(const std::vector<AnthropometricValue>& values,
                               const std::vector<FacePlace>& places, const NormSet* norms);

}  // namespace mien
