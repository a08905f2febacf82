#include "registration/feature_places.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>

#include "model/landmarks.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

// Places of prefix0, prefix1, ... at rest; empty when one is missing.
std::vector<Vector3> landmark_places(const DeformationModel& model, const std::string& prefix,
                                     int count, int digits) {
    std::vector<Vector3> places;
    for (int k = 0; k < count; ++k) {
        std::string number = std::to_string(k);
        number.insert(
            0, static_cast<std::size_t>(std::max(0, digits - static_cast<int>(number.size()))),
            '0');
        const Landmark* landmark = find_landmark(model.landmarks, prefix + number);
        if (landmark == nullptr) return {};
        places.push_back(model.template_mesh.vertices.row(landmark->vertex).transpose());
    }
    return places;
}

double distance_to_line(const Vector3& point, const std::vector<Vector3>& line, bool closed) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + (closed ? 0 : 1) < line.size(); ++k) {
        const Vector3& from = line[k];
        const Vector3 along = line[(k + 1) % line.size()] - from;
        const double squared = along.squaredNorm();
        const double t =
            squared > 0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0;
        best = std::min(best, (point - from - t * along).norm());
    }
    return best;
}

// Whether the point lies within the ring, seen along the ring's own normal.
bool is_within(const Vector3& point, const std::vector<Vector3>& ring) {
    Vector3 centre = Vector3::Zero(), normal = Vector3::Zero();
    for (const Vector3& corner : ring) centre += corner / static_cast<double>(ring.size());
    for (std::size_t k = 0; k < ring.size(); ++k)
        normal += (ring[k] - centre).cross(ring[(k + 1) % ring.size()] - centre);
    if (!(normal.norm() > 0)) return false;
    normal.normalize();
    const Vector3 across = normal.unitOrthogonal(), up = normal.cross(across);
    const double x = across.dot(point - centre), y = up.dot(point - centre);
    bool within = false;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vector3 a = ring[k] - centre, b = ring[(k + 1) % ring.size()] - centre;
        const double ax = across.dot(a), ay = up.dot(a), bx = across.dot(b), by = up.dot(b);
        if ((ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)) within = !within;
    }
    return within;
}

// Signed distance of every vertex to the rim of a zone, positive inside; empty when it has no rim.
std::vector<double> inside_zone_mm(const TriMesh& mesh, const Zone& zone, const Context& context) {
    std::vector<double> inside_mm(static_cast<std::size_t>(mesh.vertices.rows()));
    std::vector<std::uint8_t> member(inside_mm.size(), 0);
    for (const std::uint32_t v : zone.vertices) member[v] = 1;
    std::vector<Vector3> rim;
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles(t, k), b = mesh.triangles(t, (k + 1) % 3);
            if (member[a] && !member[b])
                rim.push_back(0.5 * (mesh.vertices.row(a) + mesh.vertices.row(b)).transpose());
        }
    if (rim.empty()) return {};
    const TriangleTree tree(
        Eigen::Map<const Points>(rim.front().data(), static_cast<Index>(rim.size()), 3),
        Triangles(0, 3), context);
    for (std::size_t i = 0; i < inside_mm.size(); ++i) {
        const double distance =
            tree.closest(mesh.vertices.row(static_cast<Index>(i)).transpose()).distance();
        inside_mm[i] = member[i] ? distance : -distance;
    }
    return inside_mm;
}

}  // namespace

std::vector<double> inside_brow_mm(const DeformationModel& model, const std::string& side,
                                   double half_mm) {
    const std::vector<Vector3> line = landmark_places(model, "brow_" + side + "_", 5, 1);
    if (line.empty()) return {};
    std::vector<double> inside_mm(static_cast<std::size_t>(model.num_vertices()));
    for (std::size_t i = 0; i < inside_mm.size(); ++i)
        inside_mm[i] =
            half_mm -
            distance_to_line(model.template_mesh.vertices.row(static_cast<Index>(i)).transpose(),
                             line, false);
    return inside_mm;
}

std::vector<double> inside_lips_mm(const DeformationModel& model, double depth_mm,
                                   const Context& context) {
    if (const Zone* lips = find_zone(model.zones, "lips"))
        return inside_zone_mm(model.template_mesh, *lips, context);
    const std::vector<Vector3> ring = landmark_places(model, "mouth_outer_", 12, 2);
    if (ring.empty()) return {};
    std::vector<double> inside_mm(static_cast<std::size_t>(model.num_vertices()));
    for (std::size_t i = 0; i < inside_mm.size(); ++i) {
        const Vector3 at = model.template_mesh.vertices.row(static_cast<Index>(i)).transpose();
        const double distance = distance_to_line(at, ring, true);
        inside_mm[i] = distance < depth_mm && is_within(at, ring) ? distance : -distance;
    }
    return inside_mm;
}

}  // namespace mien
