#include "registration/transfer.hpp"

#include "base/error.hpp"
#include "base/json_text.hpp"
#include "mesh/length_unit.hpp"

namespace mien {
SurfaceTransfer::SurfaceTransfer(const TriMesh& fitted, const TriMesh& scan, const Context& context)
    : fitted_(fitted), scan_(scan) {
    check_mesh(fitted_, "the fitted template");
    check_mesh(scan_, "the scan");
    if (fitted_.triangles.rows() == 0)
        fail(Status::invalid_mesh, "the fitted template has no triangles");
    fitted_tree_ = TriangleTree(fitted_.vertices, fitted_.triangles, context);
    scan_tree_ = TriangleTree(scan_.vertices, scan_.triangles, context);
    check_units(context);
}

void SurfaceTransfer::check_units(const Context& context) const {
    // A body is larger than the head fitted to it, but then the head lies on it.
    constexpr double kTooDifferent = 5, kBeside_mm = 10, kLeastShare = 0.05;
    std::vector<SurfaceHit> hits;
    scan_tree_.closest(fitted_.vertices, kBeside_mm, hits, context);
    std::size_t beside = 0;
    for (const SurfaceHit& hit : hits) beside += hit.valid();
    if (static_cast<double>(beside) < kLeastShare * static_cast<double>(hits.size()))
        check_same_unit(fitted_.vertices, "the fitted template", scan_.vertices, "the scan",
                        kTooDifferent);
}

std::vector<SurfaceHit> SurfaceTransfer::points(const PointsRef& places,
                                                TransferDirection direction, double max_distance_mm,
                                                const Context& context) const {
    std::vector<SurfaceHit> hits;
    const TriangleTree& tree = direction == TransferDirection::to_scan ? scan_tree_ : fitted_tree_;
    tree.closest(places, max_distance_mm, hits, context);
    return hits;
}

std::vector<std::uint32_t> SurfaceTransfer::zone(const std::vector<std::uint32_t>& vertices,
                                                 TransferDirection direction,
                                                 double max_distance_mm,
                                                 const Context& context) const {
    const bool to_scan = direction == TransferDirection::to_scan;
    const TriMesh& from = to_scan ? fitted_ : scan_;
    const TriMesh& to = to_scan ? scan_ : fitted_;
    const TriangleTree& tree = to_scan ? fitted_tree_ : scan_tree_;
    std::vector<double> member(static_cast<std::size_t>(from.vertices.rows()), 0);
    for (const std::uint32_t v : vertices) {
        if (v >= member.size())
            fail(Status::mismatch, "zone vertex %u, but the mesh has %zu vertices", v,
                 member.size());
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
                     member[tree.is_point_cloud()
                                ? hits[i].triangle
                                : from.triangles(static_cast<Index>(hits[i].triangle), k)];
        if (share >= 0.5) inside.push_back(static_cast<std::uint32_t>(i));
    }
    return inside;
}

std::string transferred_landmarks_json(const SurfaceTransfer& transfer,
                                       const std::vector<Landmark>& landmarks,
                                       double max_distance_mm, const Context& context) {
    Points places(static_cast<Index>(landmarks.size()), 3);
    for (std::size_t k = 0; k < landmarks.size(); ++k) {
        if (landmarks[k].vertex >= static_cast<std::uint64_t>(transfer.fitted().vertices.rows()))
            fail(Status::mismatch,
                 "landmark '%.60s' is vertex %u, which the fitted mesh does not have",
                 landmarks[k].name.c_str(), landmarks[k].vertex);
        places.row(static_cast<Index>(k)) = transfer.fitted().vertices.row(landmarks[k].vertex);
    }
    const std::vector<SurfaceHit> hits =
        transfer.points(places, TransferDirection::to_scan, max_distance_mm, context);
    JsonText points, distances;
    points.begin_object();
    distances.begin_object();
    for (std::size_t k = 0; k < hits.size(); ++k) {
        if (!hits[k].valid()) continue;
        points.field(landmarks[k].name, hits[k].point);
        distances.field(landmarks[k].name, hits[k].distance());
    }
    JsonText json;
    json.begin_object().key("points").raw(points.end_object().take());
    return json.key("distances_mm").raw(distances.end_object().take()).end_object().take();
}

std::string transferred_zones_json(const SurfaceTransfer& transfer, const std::vector<Zone>& zones,
                                   double max_distance_mm, const Context& context) {
    JsonText json;
    json.begin_object().key("zones").begin_object();
    for (const Zone& zone : zones)
        json.field(zone.name, transfer.zone(zone.vertices, TransferDirection::to_scan,
                                            max_distance_mm, context));
    return json.end_object().end_object().take();
}

}  // namespace mien
