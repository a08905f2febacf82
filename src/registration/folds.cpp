#include "registration/folds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "base/error.hpp"
#include "geometry/normals.hpp"

namespace mien {
namespace {

// The vertices within `reach` rings of a triangle's corners.
void gather(const VertexRings& rings, const std::array<std::uint32_t, 3>& corners, int reach,
            std::vector<std::uint32_t>& around) {
    around.assign(corners.begin(), corners.end());
    std::size_t begin = 0;
    for (int ring = 0; ring < reach; ++ring) {
        const std::size_t end = around.size();
        for (std::size_t k = begin; k < end; ++k)
            for (const std::uint32_t j : rings.of(around[k]))
                if (std::find(around.begin(), around.end(), j) == around.end()) around.push_back(j);
        begin = end;
    }
}

// The rotation that brings rest places nearest to places, of the given vertices.
Matrix3 local_rotation(const PointsRef& rest, const PointsRef& places,
                       const std::vector<std::uint32_t>& vertices) {
    Eigen::RowVector3d from = Eigen::RowVector3d::Zero(), to = Eigen::RowVector3d::Zero();
    for (const std::uint32_t v : vertices) from += rest.row(v), to += places.row(v);
    from /= static_cast<double>(vertices.size());
    to /= static_cast<double>(vertices.size());
    Matrix3 covariance = Matrix3::Zero();
    for (const std::uint32_t v : vertices)
        covariance += (places.row(v) - to).transpose() * (rest.row(v) - from);
    const Eigen::JacobiSVD<Matrix3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    if (svd.info() != Eigen::Success)
        fail(Status::no_solution, "registration: the turn of a fold is not finite");
    Matrix3 u = svd.matrixU();
    if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) = -u.col(2);
    return u * svd.matrixV().transpose();
}

std::array<std::uint32_t, 3> corners_of(const Triangles& triangles, Index t) {
    return {triangles(t, 0), triangles(t, 1), triangles(t, 2)};
}

// The vertices that a round moves, and the rotation that each goes by.
struct Touched {
    std::vector<std::uint8_t> is;
    std::vector<Matrix3> rotation;
};

// One step of relaxation: every touched vertex towards the place that its neighbours give it.
Points relax(const PointsRef& rest, const VertexRings& rings, const Touched& touched, double keep,
             const Points& places) {
    Points moved = places;
    for (std::size_t i = 0; i < touched.is.size(); ++i) {
        const VertexSpan ring = rings.of(i);
        if (!touched.is[i] || ring.size() == 0) continue;
        const Index v = static_cast<Index>(i);
        Vector3 mean = Vector3::Zero();
        for (const std::uint32_t j : ring)
            mean += places.row(j).transpose() +
                    touched.rotation[i] * (rest.row(v) - rest.row(j)).transpose();
        mean /= static_cast<double>(ring.size());
        moved.row(v) = keep * places.row(v) + (1 - keep) * mean.transpose();
    }
    return moved;
}

}  // namespace

std::vector<TurnedTriangle> find_turned(const PointsRef& rest, const Triangles& triangles,
                                        const VertexRings& rings, const PointsRef& places,
                                        const FoldSettings& settings) {
    const Points now = triangle_normals(places, triangles),
                 before = triangle_normals(rest, triangles);
    const double least = std::cos(settings.max_turn_rad);
    std::vector<TurnedTriangle> turned;
    std::vector<std::uint32_t> around;
    for (Index t = 0; t < triangles.rows(); ++t) {
        if (!(before.row(t).norm() > 0)) continue;
        const double scale = now.row(t).norm() * before.row(t).norm();
        if (now.row(t).dot(before.row(t)) > std::max(least, settings.plain_cosine) * scale)
            continue;
        gather(rings, corners_of(triangles, t), settings.reach, around);
        const Matrix3 rotation = local_rotation(rest, places, around);
        if (now.row(t).dot((rotation * before.row(t).transpose()).transpose()) <= least * scale)
            turned.push_back({static_cast<std::uint32_t>(t), rotation});
    }
    return turned;
}

FoldCounts straighten_turned(const PointsRef& rest, const Triangles& triangles,
                             const VertexRings& rings, const FoldSettings& settings,
                             Points& places) {
    std::vector<TurnedTriangle> turned = find_turned(rest, triangles, rings, places, settings);
    FoldCounts counts;
    counts.before = counts.after = static_cast<Index>(turned.size());
    if (!settings.straighten) return counts;
    Points best = places;
    std::size_t fewest = turned.size();
    std::vector<std::uint32_t> around;
    Touched touched;
    touched.rotation.resize(static_cast<std::size_t>(places.rows()));
    for (int round = 0; round < settings.rounds && !turned.empty(); ++round) {
        touched.is.assign(static_cast<std::size_t>(places.rows()), 0);
        for (const TurnedTriangle& one : turned) {
            gather(rings, corners_of(triangles, static_cast<Index>(one.triangle)),
                   round < settings.widen_after ? 0 : 1, around);
            for (const std::uint32_t v : around)
                touched.is[v] = 1, touched.rotation[v] = one.rotation;
        }
        for (int step = 0; step < settings.steps; ++step)
            places = relax(rest, rings, touched, settings.keep, places);
        turned = find_turned(rest, triangles, rings, places, settings);
        if (turned.size() < fewest) fewest = turned.size(), best = places;
    }
    places = best;
    counts.after = static_cast<Index>(fewest);
    return counts;
}

}  // namespace mien
