// How a face's left side differs from its right: the face against its own reflection about its
// mirror plane (mirror_plane.hpp), as volume and distance per zone of the left side, signed:
// positive where the left side lies farther out.
//
// A reflected face has the topology of the face (vertex v is the reflection of its partner), so
// volume.hpp and distance.hpp measure the pair on the triangles of the left side and of the
// plane's. A zone is compared as a whole: "cheek_left" and "cheek_right" are one comparison,
// "cheek"; of a zone in the middle ("nose") its left half is compared with its right half.
//
// Deviation: both surfaces' errors (a vertex and its partner), and the plane's: a plane that turns
// by a moves the reflected face by 2 a. A face that slid along the skin on one side only changes no
// volume to first order, but lengths of displacements, which are therefore not signed and larger
// than they should be.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "measure/measurement.hpp"
#include "measure/mirror_plane.hpp"

namespace mien {

enum class MirrorBy : std::int32_t { surface = 0, landmarks = 1 };

struct AsymmetryOptions {
    std::vector<Zone> zones;               ///< of the template, either side
    std::vector<std::uint32_t> landmarks;  ///< vertices; their partners count as well
    MirrorBy by = MirrorBy::surface;       ///< landmarks: the plane is fitted to them alone
    Vector normal_sd_mm;  ///< #V, of the face along its normal; empty: no deviation is told
    double correlation_length_mm = kSurfaceCorrelationMm;  ///< of the face's errors, >= 0
    /// A surface that is less sure than this counts less for the plane, mm, > 0. Not measured:
    /// about the asymmetry of faces, which is there anyway.
    double plane_noise_mm = 0.5;
    MirrorPlaneSettings plane;
};

/// The planes that were found, and the one that was used.
struct AsymmetryPlanes {
    MirrorBy by = MirrorBy::surface;
    MirrorPlane used;
    std::optional<MirrorPlane> other;  ///< by the other way, where there are landmarks
    double between_rad = 0.0;          ///< angle between both; not a number without the other
    double apart_mm = 0.0;             ///< of the other plane from the used one's centre, signed
};

struct Asymmetry {
    AsymmetryPlanes planes;
    /// volume, verdicts and distance of the comparisons; "whole" is the left side against the
    /// right. Fields per vertex are of all vertices: of a right one, against the reflected left.
    Measurement measurement;
};

/// Throws Status::mismatch for a map, zones or deviations of another topology, invalid_argument
/// (landmarks asked for without any), and as find_mirror_plane() and measure_volume_fully().
Asymmetry measure_asymmetry(const TriMesh& face, const MirrorMap& map,
                            const AsymmetryOptions& options, const Context& context);

/// {"asymmetry": {the planes}, "volume": ..., "distance": ...}, otherwise as measurement_json().
std::string asymmetry_json(const Asymmetry& asymmetry);

/// The comparisons of zones: name without its side, vertices of the left side and of the plane.
std::vector<Zone> compared_zones(const std::vector<Zone>& zones, const MirrorMap& map);

}  // namespace mien
