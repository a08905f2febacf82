#include "mesh/winding.hpp"

#include <cmath>
#include <Eigen/Geometry>
#include <utility>

#include "mesh/topology.hpp"

namespace mien {
namespace {

/// Area, and area times how far a triangle faces away from the middle.
struct Facing {
    std::vector<double> area, outward;
    double total_area = 0;
};

Facing facing_of(const TriMesh& mesh) {
    const Index count = mesh.triangles.rows();
    Facing facing;
    facing.area.resize(static_cast<std::size_t>(count));
    facing.outward.resize(static_cast<std::size_t>(count));
    const auto corner = [&](Index t, int k) -> Vector3 {
        return mesh.vertices.row(mesh.triangles(t, k)).transpose();
    };
    Vector3 middle = Vector3::Zero();
    for (Index t = 0; t < count; ++t) {
        const double area =
            0.5 * (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).norm();
        facing.area[static_cast<std::size_t>(t)] = area;
        facing.total_area += area;
        middle += area / 3 * (corner(t, 0) + corner(t, 1) + corner(t, 2));
    }
    if (!(facing.total_area > 0)) return facing;
    middle /= facing.total_area;
    for (Index t = 0; t < count; ++t) {
        const Vector3 cross = (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
        const Vector3 away = (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3 - middle;
        const double length = away.norm();
        facing.outward[static_cast<std::size_t>(t)] =
            length > 0 ? 0.5 * cross.dot(away) / length : 0;
    }
    return facing;
}

/// Walks over edges of two sides; sets turned[t] relative to the piece's first triangle.
class Walk {
  public:
    Walk(const Triangles& triangles, const EdgeTable& table)
        : triangles_(triangles),
          table_(table),
          edge_of_side_(3 * static_cast<std::size_t>(triangles.rows()), kNone) {
        for (std::size_t e = 0; e < table.num_edges(); ++e)
            if (table.num_sides(e) == 2)
                for (std::uint32_t s = table.first_side[e]; s < table.first_side[e + 1]; ++s)
                    edge_of_side_[table.sides[s]] = static_cast<std::uint32_t>(e);
    }

    std::vector<std::vector<std::uint32_t>> pieces;
    std::vector<std::uint8_t> turned;
    Index num_impossible = 0;

    void run(const Context& context) {
        const std::size_t count = static_cast<std::size_t>(triangles_.rows());
        turned.assign(count, 0);
        std::vector<std::uint8_t> seen(count, 0);
        for (std::size_t first = 0; first < count; ++first) {
            if (seen[first]) continue;
            if (pieces.size() % 1024 == 0) context.check_cancelled();
            seen[first] = 1;
            pieces.push_back({static_cast<std::uint32_t>(first)});
            for (std::size_t at = 0; at < pieces.back().size(); ++at)
                visit(pieces.back()[at], pieces.back(), seen);
        }
        num_impossible /= 2;  // each was met from both sides
    }

  private:
    static constexpr std::uint32_t kNone = 0xffffffffu;

    void visit(std::uint32_t triangle, std::vector<std::uint32_t>& piece,
               std::vector<std::uint8_t>& seen) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t side = 3 * triangle + k, edge = edge_of_side_[side];
            if (edge == kNone) continue;
            const std::uint32_t first = table_.sides[table_.first_side[edge]],
                                second = table_.sides[table_.first_side[edge] + 1],
                                other = first == side ? second : first, neighbour = other / 3;
            if (neighbour == triangle) continue;
            const bool alike = side_ends(triangles_, side)[0] == side_ends(triangles_, other)[0];
            const std::uint8_t wanted = turned[triangle] ^ static_cast<std::uint8_t>(alike);
            if (!seen[neighbour]) {
                seen[neighbour] = 1;
                turned[neighbour] = wanted;
                piece.push_back(neighbour);
            } else if (turned[neighbour] != wanted) {
                ++num_impossible;
            }
        }
    }

    const Triangles& triangles_;
    const EdgeTable& table_;
    std::vector<std::uint32_t> edge_of_side_;
};

void turn_triangle(TriMesh& mesh, Index triangle) {
    std::swap(mesh.triangles(triangle, 1), mesh.triangles(triangle, 2));
    if (mesh.texture_triangles.rows() == mesh.triangles.rows())
        std::swap(mesh.texture_triangles(triangle, 1), mesh.texture_triangles(triangle, 2));
}

}  // namespace

void turn_over(TriMesh& mesh) {
    for (Index t = 0; t < mesh.triangles.rows(); ++t) turn_triangle(mesh, t);
}

double outward_share(const TriMesh& mesh) {
    const Facing facing = facing_of(mesh);
    double sum = 0;
    for (const double outward : facing.outward) sum += outward;
    return facing.total_area > 0 ? sum / facing.total_area : 0;
}

WindingReport make_windings_consistent(TriMesh& mesh, const WindingSettings& settings,
                                       const Context& context) {
    WindingReport report;
    if (mesh.triangles.rows() == 0) return report;
    const Facing facing = facing_of(mesh);
    const EdgeTable table = build_edge_table(mesh.triangles, mesh.vertices.rows(), context);
    Walk walk(mesh.triangles, table);
    walk.run(context);
    report.num_pieces = static_cast<Index>(walk.pieces.size());
    report.num_impossible_edges = walk.num_impossible;

    // Within a piece, the part of less area is turned.
    struct Piece {
        double area = 0, outward = 0;
    };
    std::vector<Piece> sums(walk.pieces.size());
    double outward = 0;
    for (std::size_t p = 0; p < walk.pieces.size(); ++p) {
        double kept = 0, turned = 0;
        for (const std::uint32_t t : walk.pieces[p])
            (walk.turned[t] ? turned : kept) += facing.area[t];
        for (const std::uint32_t t : walk.pieces[p]) {
            if (turned > kept) walk.turned[t] ^= 1;
            sums[p].area += facing.area[t];
            sums[p].outward += walk.turned[t] ? -facing.outward[t] : facing.outward[t];
        }
        outward += sums[p].outward;
    }
    // Between pieces, those that clearly face the other way than the whole.
    const double least = settings.least_share * static_cast<double>(mesh.triangles.rows());
    for (std::size_t p = 0; p < walk.pieces.size(); ++p) {
        const bool against = sums[p].outward * outward < 0;
        const bool clearly = std::abs(sums[p].outward) > settings.clearly * sums[p].area;
        if (!against || !clearly || static_cast<double>(walk.pieces[p].size()) < least) continue;
        for (const std::uint32_t t : walk.pieces[p]) walk.turned[t] ^= 1;
    }
    double sum = 0;
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        const std::size_t i = static_cast<std::size_t>(t);
        sum += walk.turned[i] ? -facing.outward[i] : facing.outward[i];
        if (!walk.turned[i]) continue;
        report.turned.push_back(static_cast<std::uint32_t>(t));
        turn_triangle(mesh, t);
    }
    report.outward = facing.total_area > 0 ? sum / facing.total_area : 0;
    return report;
}

}  // namespace mien
