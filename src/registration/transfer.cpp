#include "registration/transfer.hpp"

#include <charconv>

#include "base/error.hpp"
#include "base/json.hpp"

namespace mien {
namespace {

void append_number(std::string& json, double value) {
    char text[40];
    json.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

}  // namespace

SurfaceTransfer::SurfaceTransfer(const TriMesh& fitted, const TriMesh& scan, const Context& context)
    : fitted_(fitted), scan_(scan) {
    check_mesh(fitted_, "the fitted template");
    check_mesh(scan_, "the scan");
    if (fitted_.triangles.rows() == 0) fail(Status::invalid_mesh, "the fitted template has no triangles");
    fitted_tree_ = TriangleTree(fitted_.vertices, fitted_.triangles, context);
    scan_tree_ = TriangleTree(scan_.vertices, scan_.triangles, context);
}

std::vector<SurfaceHit> SurfaceTransfer::points(const PointsRef& places, TransferDirection direction,
                                                double max_distance_mm, const Context& context) const {
    std::vector<SurfaceHit> hits;
    const TriangleTree& tree = direction == TransferDirection::to_scan ? scan_tree_ : fitted_tree_;
    tree.closest(places, max_distance_mm, hits, context);
    return hits;
}

std::vector<std::uint32_t> SurfaceTransfer::zone(const std::vector<std::uint32_t>& vertices,
                                                 TransferDirection direction, double max_distance_mm,
                                                 const Context& context) const {
    const bool to_scan = direction == TransferDirection::to_scan;
    const TriMesh& from = to_scan ? fitted_ : scan_;
    const TriMesh& to = to_scan ? scan_ : fitted_;
    const TriangleTree& tree = to_scan ? fitted_tree_ : scan_tree_;
    std::vector<double> member(static_cast<std::size_t>(from.vertices.rows()), 0);
    for (const std::uint32_t v : vertices) {
        if (v >= member.size())
            fail(Status::mismatch, "zone vertex %u, but the mesh has %zu vertices", v, member.size());
        member[v] = 1;
    }
    std::vector<SurfaceHit> hits;
    tree.closest(to.vertices, max_distance_mm, hits, context);
    std::vector<std::uint32_t> inside;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (!hits[i].valid()) continue;
        double share = 0;
        for (int k = 0; k < 3; ++k)
            share += hits[i].barycentric[k] *
                     member[tree.is_point_cloud() ? hits[i].triangle
                                                  : from.triangles(static_cast<Index>(hits[i].triangle), k)];
        if (share >= 0.5) inside.push_back(static_cast<std::uint32_t>(i));
    }
    return inside;
}

std::string transferred_landmarks_json(const SurfaceTransfer& transfer, const std::vector<Landmark>& landmarks,
                                       double max_distance_mm, const Context& context) {
    Points places(static_cast<Index>(landmarks.size()), 3);
    for (std::size_t k = 0; k < landmarks.size(); ++k) {
        if (landmarks[k].vertex >= static_cast<std::uint64_t>(transfer.fitted().vertices.rows()))
            fail(Status::mismatch, "landmark '%.60s' is vertex %u, which the fitted mesh does not have",
                 landmarks[k].name.c_str(), landmarks[k].vertex);
        places.row(static_cast<Index>(k)) = transfer.fitted().vertices.row(landmarks[k].vertex);
    }
    const std::vector<SurfaceHit> hits =
        transfer.points(places, TransferDirection::to_scan, max_distance_mm, context);
    std::string points = "{\"points\":{", distances = "},\"distances_mm\":{";
    bool first = true;
    for (std::size_t k = 0; k < hits.size(); ++k) {
        if (!hits[k].valid()) continue;
        if (!first) points += ',', distances += ',';
        first = false;
        append_json_string(points, landmarks[k].name);
        points += ":[";
        for (int axis = 0; axis < 3; ++axis) {
            if (axis > 0) points += ',';
            append_number(points, hits[k].point[axis]);
        }
        points += ']';
        append_json_string(distances, landmarks[k].name);
        distances += ':';
        append_number(distances, hits[k].distance());
    }
    return points + distances + "}}";
}

std::string transferred_zones_json(const SurfaceTransfer& transfer, const std::vector<Zone>& zones,
                                   double max_distance_mm, const Context& context) {
    std::string json = "{\"zones\":{";
    for (std::size_t z = 0; z < zones.size(); ++z) {
        if (z > 0) json += ',';
        append_json_string(json, zones[z].name);
        json += ":[";
        bool first = true;
        for (const std::uint32_t v :
             transfer.zone(zones[z].vertices, TransferDirection::to_scan, max_distance_mm, context)) {
            if (!first) json += ',';
            first = false;
            json += std::to_string(v);
        }
        json += ']';
    }
    return json + "}}";
}

}  // namespace mien
