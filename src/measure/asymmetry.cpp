#include "measure/asymmetry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/scalar_math.hpp"
#include "measure/area.hpp"
#include "measure/pair_check.hpp"

namespace mien {
namespace {

/// "cheek_left" and "Left cheek" without the side and the separator beside it; names without a side
/// stay as they are.
std::string without_side(const std::string& name) {
    std::string lower = name;
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const auto separates = [&](std::size_t i) {
        return lower[i] == '_' || lower[i] == ' ' || lower[i] == '-' || lower[i] == '.';
    };
    for (const std::string side : {"left", "right"}) {
        if (lower.size() <= side.size() + 1) continue;
        const std::size_t tail = lower.size() - side.size();
        if (lower.compare(tail, side.size(), side) == 0 && separates(tail - 1))
            return name.substr(0, tail - 1);
        if (lower.compare(0, side.size(), side) == 0 && separates(side.size()))
            return name.substr(side.size() + 1);
    }
    return name;
}

Triangles left_triangles(const TrianglesRef& triangles, const MirrorMap& map) {
    std::vector<Index> kept;
    for (Index t = 0; t < triangles.rows(); ++t) {
        int sum = 0, lowest = 1;
        for (int k = 0; k < 3; ++k) {
            const int side = map.side[triangles(t, k)];
            sum += side;
            lowest = std::min(lowest, side);
        }
        if (sum > 0 && lowest >= 0) kept.push_back(t);
    }
    Triangles left(static_cast<Index>(kept.size()), 3);
    for (std::size_t i = 0; i < kept.size(); ++i)
        left.row(static_cast<Index>(i)) = triangles.row(kept[i]);
    return left;
}

/// Areas at the landmarks and their partners alone: all alike.
Vector landmark_weights(const std::vector<std::uint32_t>& landmarks, const MirrorMap& map) {
    Vector weights = Vector::Zero(static_cast<Index>(map.partner.size()));
    for (const std::uint32_t v : landmarks) {
        if (v >= map.partner.size())
            fail(Status::mismatch, "landmark vertex %u of a face with %zu vertices", v,
                 map.partner.size());
        weights[v] = weights[map.partner[v]] = 1.0;
    }
    return weights;
}

/// Pairs of landmarks that go together. On 24 fits of simulated scans the plane by landmarks
/// lay 3.0 times farther from the true faces' than it does when each pair stands for itself; on 24
/// others 2.8 times (tests/bench/README.md).
constexpr double kLandmarksTogether = 9.0;

/// Landmarks have no area to count places by.
MirrorPlaneSettings for_landmarks(MirrorPlaneSettings settings) {
    settings.correlation_length_mm = 0.0;
    settings.pairs_together = kLandmarksTogether;
    return settings;
}

/// Areas, less where the face itself is not sure of its surface: parts that no scan saw are the
/// model's, and a model's face is symmetric by itself.
Vector surface_weights(const TriMesh& face, const MirrorMap& map, const AsymmetryOptions& options) {
    Vector weights = vertex_areas(face.vertices, face.triangles);
    for (Index v = 0; v < options.normal_sd_mm.size(); ++v) {
        const double ratio =
            std::max(options.normal_sd_mm[v],
                     options.normal_sd_mm[map.partner[static_cast<std::size_t>(v)]]) /
            options.plane_noise_mm;
        weights[v] /= 1.0 + ratio * ratio;
    }
    return weights;
}

AsymmetryPlanes find_planes(const TriMesh& face, const MirrorMap& map,
                            const AsymmetryOptions& options) {
    AsymmetryPlanes planes;
    planes.by = options.by;
    const MirrorPlane surface =
        find_mirror_plane(face.vertices, map, surface_weights(face, map, options), options.plane);
    planes.used = surface;
    planes.between_rad = planes.apart_mm = std::numeric_limits<double>::quiet_NaN();
    if (options.landmarks.empty()) {
        if (options.by == MirrorBy::landmarks)
            fail(Status::invalid_argument,
                 "a mirror plane by landmarks was asked for, and there are none");
        return planes;
    }
    planes.other = find_mirror_plane(face.vertices, map, landmark_weights(options.landmarks, map),
                                     for_landmarks(options.plane));
    if (options.by == MirrorBy::landmarks) std::swap(planes.used, *planes.other);
    planes.between_rad = std::atan2(planes.used.normal.cross(planes.other->normal).norm(),
                                    planes.used.normal.dot(planes.other->normal));
    planes.apart_mm = planes.other->offset_mm() - planes.other->normal.dot(planes.used.centre);
    return planes;
}

void write_plane(JsonText& json, const MirrorPlane& plane, MirrorBy by) {
    json.begin_object();
    json.field("by", by == MirrorBy::surface ? "surface" : "landmarks");
    json.field("normal", std::vector<double>{plane.normal[0], plane.normal[1], plane.normal[2]});
    json.field("centre_mm", std::vector<double>{plane.centre[0], plane.centre[1], plane.centre[2]});
    json.field("pairs", static_cast<std::int64_t>(plane.pairs));
    json.field("rms_mm", plane.rms_mm);
    json.field("tilt_sd_degrees", plane.tilt_sd_rad() / kRadiansPerDegree);
    json.field("offset_sd_mm", plane.offset_sd_mm());
    json.end_object();
}

VolumeErrorModel errors_of(const AsymmetryOptions& options, const MirrorMap& map,
                           const MirrorPlane& plane) {
    VolumeErrorModel errors;
    errors.sd_after_mm = options.normal_sd_mm;
    errors.sd_before_mm.resize(options.normal_sd_mm.size());
    for (Index v = 0; v < errors.sd_before_mm.size(); ++v)
        errors.sd_before_mm[v] = options.normal_sd_mm[map.partner[static_cast<std::size_t>(v)]];
    errors.correlation_length_mm = options.correlation_length_mm;
    errors.alignment_covariance = plane.motion_covariance();
    errors.alignment_centre = plane.centre;
    return errors;
}

}  // namespace

std::vector<Zone> compared_zones(const std::vector<Zone>& zones, const MirrorMap& map) {
    std::vector<Zone> compared;
    for (const Zone& zone : zones) {
        const std::string name = without_side(zone.name);
        auto at = std::find_if(compared.begin(), compared.end(),
                               [&](const Zone& one) { return one.name == name; });
        if (at == compared.end()) at = compared.insert(compared.end(), {name, {}});
        for (const std::uint32_t v : zone.vertices) {
            if (v >= map.side.size())
                fail(Status::mismatch, "zone '%.60s' names vertex %u of a face with %zu vertices",
                     zone.name.c_str(), v, map.side.size());
            at->vertices.push_back(map.side[v] >= 0 ? v : map.partner[v]);
        }
    }
    for (Zone& zone : compared) {
        std::sort(zone.vertices.begin(), zone.vertices.end());
        zone.vertices.erase(std::unique(zone.vertices.begin(), zone.vertices.end()),
                            zone.vertices.end());
    }
    return compared;
}

Asymmetry measure_asymmetry(const TriMesh& face, const MirrorMap& map,
                            const AsymmetryOptions& options, const Context& context) {
    check_surface(face.vertices, face.triangles, "the face");
    if (map.side.size() != static_cast<std::size_t>(face.vertices.rows()))
        fail(Status::mismatch, "a template of %zu vertices mirrors a face of %lld", map.side.size(),
             static_cast<long long>(face.vertices.rows()));
    if (options.normal_sd_mm.size() != 0 && options.normal_sd_mm.size() != face.vertices.rows())
        fail(Status::mismatch, "%lld deviations for %lld vertices",
             static_cast<long long>(options.normal_sd_mm.size()),
             static_cast<long long>(face.vertices.rows()));
    for (Index v = 0; v < options.normal_sd_mm.size(); ++v)
        if (!(options.normal_sd_mm[v] >= 0) || !std::isfinite(options.normal_sd_mm[v]))
            fail_at(Status::invalid_argument, v,
                    "deviation %lld is %g; deviations are zero or more", static_cast<long long>(v),
                    options.normal_sd_mm[v]);
    if (!(options.plane_noise_mm > 0) || !std::isfinite(options.plane_noise_mm))
        fail(Status::invalid_argument, "plane_noise_mm is %g; give more than zero",
             options.plane_noise_mm);
    Asymmetry result;
    result.planes = find_planes(face, map, options);
    const MirrorPlane& plane = result.planes.used;
    Points reflected(face.vertices.rows(), 3);
    for (Index v = 0; v < reflected.rows(); ++v)
        reflected.row(v) =
            plane.reflect(face.vertices.row(map.partner[static_cast<std::size_t>(v)]).transpose())
                .transpose();
    const Triangles left = left_triangles(face.triangles, map);
    if (left.rows() == 0)
        fail(Status::invalid_mesh, "the template has no triangle on its left side (x > 0)");
    MeasureOptions measure;
    measure.zones = compared_zones(options.zones, map);
    if (options.normal_sd_mm.size() != 0) measure.errors = errors_of(options, map, plane);
    result.measurement = measure_volume_fully(reflected, face.vertices, left, measure, context);
    result.measurement.distance =
        measure_distance(reflected, face.vertices, left, measure.zones, context);
    const DistanceReport all =
        measure_distance(reflected, face.vertices, face.triangles, {}, context);
    result.measurement.distance->signed_mm = all.signed_mm;
    result.measurement.distance->length_mm = all.length_mm;
    result.measurement.shares =
        volume_per_vertex(reflected, face.vertices, face.triangles, context);
    return result;
}

std::string asymmetry_json(const Asymmetry& asymmetry) {
    const AsymmetryPlanes& planes = asymmetry.planes;
    JsonText json;
    json.begin_object();
    json.key("asymmetry").begin_object();
    json.field("sign",
               "positive: the left side lies farther out; before: the right side's reflection, "
               "after: the left side; whole: all of the left side");
    json.key("plane");
    write_plane(json, planes.used, planes.by);
    if (planes.other) {
        json.key("other_plane");
        write_plane(json, *planes.other,
                    planes.by == MirrorBy::surface ? MirrorBy::landmarks : MirrorBy::surface);
        json.field("between_degrees", planes.between_rad / kRadiansPerDegree);
        json.field("apart_mm", planes.apart_mm);
    }
    json.end_object();
    write_measurement(json, asymmetry.measurement);
    json.end_object();
    return json.take();
}

}  // namespace mien
