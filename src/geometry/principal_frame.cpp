#include "geometry/principal_frame.hpp"

#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "base/error.hpp"

namespace mien {
namespace {

// Calls visit(place, mass): the middles of a triangle's sides, a third of its area each, have the
// triangle's own first and second moments.
template <typename Visit>
void each_mass(const Points& vertices, const Triangles& triangles, const Visit& visit) {
    for (Index i = 0; triangles.rows() == 0 && i < vertices.rows(); ++i)
        visit(Vector3(vertices.row(i)), 1.0);
    for (Index t = 0; t < triangles.rows(); ++t) {
        const Vector3 a = vertices.row(triangles(t, 0)), b = vertices.row(triangles(t, 1)),
                      c = vertices.row(triangles(t, 2));
        const double mass = (b - a).cross(c - a).norm();
        visit(Vector3(0.5 * (a + b)), mass);
        visit(Vector3(0.5 * (b + c)), mass);
        visit(Vector3(0.5 * (c + a)), mass);
    }
}

}  // namespace

Matrix3 principal_frame(const Points& vertices, const Triangles& triangles) {
    double total = 0;
    Vector3 sum = Vector3::Zero();
    each_mass(vertices, triangles, [&](const Vector3& place, double mass) {
        total += mass;
        sum += mass * place;
    });
    if (total == 0) return Matrix3::Identity();
    const Vector3 middle = sum / total;
    Matrix3 spread = Matrix3::Zero();
    each_mass(vertices, triangles, [&](const Vector3& place, double mass) {
        spread += mass / total * (place - middle) * (place - middle).transpose();
    });
    const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(spread);
    if (!spread.allFinite() || eigen.info() != Eigen::Success)
        fail(Status::no_solution, "the surface's vertices are not finite");
    Matrix3 frame = eigen.eigenvectors().rowwise().reverse();
    Vector3 lean = Vector3::Zero();
    each_mass(vertices, triangles, [&](const Vector3& place, double mass) {
        const Eigen::Array3d along = (frame.transpose() * (place - middle)).array();
        lean += mass / total * along.cube().matrix();
    });
    Index least;
    lean.cwiseAbs().minCoeff(&least);
    for (Index axis = 0; axis < 3; ++axis)
        if (axis != least && lean[axis] < 0) frame.col(axis) *= -1;
    if (frame.determinant() < 0) frame.col(least) *= -1;
    return frame;
}

}  // namespace mien
