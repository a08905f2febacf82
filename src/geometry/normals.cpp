#include "geometry/normals.hpp"

#include <Eigen/Geometry>

namespace mien {
namespace {

Eigen::RowVector3d triangle_normal(const PointsRef& vertices, const TrianglesRef& triangles,
                                   Index t) {
    const Eigen::RowVector3d a = vertices.row(triangles(t, 0));
    const Eigen::RowVector3d ab = vertices.row(triangles(t, 1)) - a;
    const Eigen::RowVector3d ac = vertices.row(triangles(t, 2)) - a;
    return ab.cross(ac);
}

}  // namespace

Points triangle_normals(const PointsRef& vertices, const TrianglesRef& triangles) {
    Points normals(triangles.rows(), 3);
    for (Index t = 0; t < triangles.rows(); ++t)
        normals.row(t) = triangle_normal(vertices, triangles, t);
    return normals;
}

Points vertex_normals(const PointsRef& vertices, const TrianglesRef& triangles) {
    Points normals = Points::Zero(vertices.rows(), 3);
    for (Index t = 0; t < triangles.rows(); ++t) {
        const Eigen::RowVector3d normal = triangle_normal(vertices, triangles, t);
        for (int k = 0; k < 3; ++k) normals.row(triangles(t, k)) += normal;
    }
    for (Index v = 0; v < normals.rows(); ++v) {
        const double length = normals.row(v).norm();
        if (length > 0) normals.row(v) /= length;
    }
    return normals;
}

}  // namespace mien
