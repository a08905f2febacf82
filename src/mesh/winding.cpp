#include "mesh/winding.hpp"

#include <cmath>
#include <Eigen/Geometry>
#include <utility>

#include "base/parallel.hpp"
#include "mesh/topology.hpp"

namespace mien {
namespace {

/// Area, and area times how far a triangle faces away from the middle.
struct Facing {
    std::vector<double> area, outward;
    double total_area = 0;
};

Facing facing_of(const TriMesh& mesh, const Context& context) {
    constexpr std::size_t kChunk = 8192;
    const std::size_t count = static_cast<std::size_t>(mesh.triangles.rows());
    Facing facing;
    facing.area.resize(count);
    facing.outward.resize(count);
    const auto corner = [&](std::size_t t, int k) -> Vector3 {
        return mesh.vertices.row(mesh.triangles(static_cast<Index>(t), k)).transpose();
    };
    // The area, and area times three times the centroid.
    Eigen::Vector4d sums = parallel_sum<Eigen::Vector4d>(
        context, count, kChunk, Eigen::Vector4d::Zero(), [&](std::size_t begin, std::size_t end) {
            Eigen::Vector4d part = Eigen::Vector4d::Zero();
            for (std::size_t t = begin; t < end; ++t) {
                const Vector3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
                const double area = 0.5 * (b - a).cross(c - a).norm();
                facing.area[t] = area;
                part[0] += area;
                part.tail<3>() += area * (a + b + c);
            }
            return part;
        });
    facing.total_area = sums[0];
    if (!(facing.total_area > 0)) return facing;
    const Vector3 middle = sums.tail<3>() / (3 * facing.total_area);
    parallel_for(context, count, kChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const Vector3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
            const Vector3 cross = (b - a).cross(c - a), away = (a + b + c) / 3 - middle;
            const double length = away.norm();
            facing.outward[t] = length > 0 ? 0.5 * cross.dot(away) / length : 0;
        }
    });
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
    const Facing facing = facing_of(mesh, {});
    double sum = 0;
    for (const double outward : facing.outward) sum += outward;
    return facing.total_area > 0 ? sum / facing.total_area : 0;
}

namespace {

struct Piece {
    double area = 0, outward = 0;
    Index num_triangles = 0;
};

// What is to be turned, piece by piece.
struct Plan {
    std::vector<std::uint32_t> piece_of;  // #F
    std::vector<Piece> pieces;
    std::vector<std::uint8_t> turned;  // #F, or empty: none
    Index num_impossible = 0;
};

// Within a piece, the part of less area is turned.
Plan plan_by_walk(const TriMesh& mesh, const Facing& facing, const Context& context) {
    const EdgeTable table = build_edge_table(mesh.triangles, mesh.vertices.rows(), context);
    Walk walk(mesh.triangles, table);
    walk.run(context);
    Plan plan;
    plan.num_impossible = walk.num_impossible;
    plan.piece_of.resize(facing.area.size());
    plan.pieces.resize(walk.pieces.size());
    for (std::size_t p = 0; p < walk.pieces.size(); ++p) {
        Piece& piece = plan.pieces[p];
        double kept = 0, turned = 0;
        for (const std::uint32_t t : walk.pieces[p])
            (walk.turned[t] ? turned : kept) += facing.area[t];
        for (const std::uint32_t t : walk.pieces[p]) {
            if (turned > kept) walk.turned[t] ^= 1;
            plan.piece_of[t] = static_cast<std::uint32_t>(p);
            piece.area += facing.area[t];
            piece.outward += walk.turned[t] ? -facing.outward[t] : facing.outward[t];
            ++piece.num_triangles;
        }
    }
    plan.turned = std::move(walk.turned);
    return plan;
}

// All triangles are wound alike, and none is turned within a piece.
Plan plan_of_alike(const TriMesh& mesh, const TriangleFans& fans, const Facing& facing) {
    Plan plan;
    plan.piece_of = pieces_across_edges(mesh.triangles, fans);
    for (std::size_t t = 0; t < plan.piece_of.size(); ++t) {
        if (plan.piece_of[t] == plan.pieces.size()) plan.pieces.emplace_back();
        Piece& piece = plan.pieces[plan.piece_of[t]];
        piece.area += facing.area[t];
        piece.outward += facing.outward[t];
        ++piece.num_triangles;
    }
    return plan;
}

WindingReport carry_out(Plan& plan, const Facing& facing, const WindingSettings& settings,
                        TriMesh& mesh) {
    WindingReport report;
    report.num_pieces = static_cast<Index>(plan.pieces.size());
    report.num_impossible_edges = plan.num_impossible;
    double whole = 0;
    for (const Piece& piece : plan.pieces) whole += piece.outward;
    // Between pieces, those that clearly face the other way than the whole.
    const double least = settings.least_share * static_cast<double>(mesh.triangles.rows());
    std::vector<std::uint8_t> turn_piece(plan.pieces.size(), 0);
    bool any = !plan.turned.empty();
    for (std::size_t p = 0; p < plan.pieces.size(); ++p) {
        const Piece& piece = plan.pieces[p];
        const bool against = piece.outward * whole < 0;
        const bool clearly = std::abs(piece.outward) > settings.clearly * piece.area;
        turn_piece[p] = against && clearly && static_cast<double>(piece.num_triangles) >= least;
        any = any || turn_piece[p] != 0;
    }
    double sum = any ? 0 : whole;
    for (std::size_t t = 0; any && t < plan.piece_of.size(); ++t) {
        const std::uint8_t within = plan.turned.empty() ? 0 : plan.turned[t];
        const bool turned = (within ^ turn_piece[plan.piece_of[t]]) != 0;
        sum += turned ? -facing.outward[t] : facing.outward[t];
        if (!turned) continue;
        report.turned.push_back(static_cast<std::uint32_t>(t));
        turn_triangle(mesh, static_cast<Index>(t));
    }
    report.outward = facing.total_area > 0 ? sum / facing.total_area : 0;
    return report;
}

bool names_a_vertex_twice(const Triangles& triangles) {
    for (Index t = 0; t < triangles.rows(); ++t)
        if (triangles(t, 0) == triangles(t, 1) || triangles(t, 1) == triangles(t, 2) ||
            triangles(t, 2) == triangles(t, 0))
            return true;
    return false;
}

}  // namespace

WindingReport make_windings_consistent(TriMesh& mesh, TriangleFans& fans,
                                       const WindingSettings& settings, const Context& context) {
    if (mesh.triangles.rows() == 0) return {};
    const Facing facing = facing_of(mesh, context);
    Plan plan = fans.wound_alike() ? plan_of_alike(mesh, fans, facing)
                                   : plan_by_walk(mesh, facing, context);
    WindingReport report = carry_out(plan, facing, settings, mesh);
    if (!report.turned.empty()) fans = TriangleFans(mesh.vertices.rows(), mesh.triangles, context);
    return report;
}

WindingReport make_windings_consistent(TriMesh& mesh, const WindingSettings& settings,
                                       const Context& context) {
    if (mesh.triangles.rows() == 0) return {};
    if (names_a_vertex_twice(mesh.triangles)) {
        const Facing facing = facing_of(mesh, context);
        Plan plan = plan_by_walk(mesh, facing, context);
        return carry_out(plan, facing, settings, mesh);
    }
    TriangleFans fans(mesh.vertices.rows(), mesh.triangles, context);
    return make_windings_consistent(mesh, fans, settings, context);
}

}  // namespace mien
