// The plain arrays that every room speaks: no room hands another one a half-edge structure.
#pragma once

#include <cstdint>
#include <Eigen/Core>

#if !defined(MIEN_EIGEN_IS_MENDED)
#error \
    "Eigen's headers do not outlive a failed allocation: link Eigen3::Eigen as cmake/MienEigen.cmake leaves it"
#endif

namespace mien {

using Index = Eigen::Index;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// #V x 3, millimetres unless a name says otherwise; row-major so that a row is one contiguous
/// point.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// #F x 3 vertex indices, counter-clockwise seen from outside.
using Triangles = Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// #V x 3, red green blue.
using Colors = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// #T x 2 texture coordinates.
using TextureCoordinates = Eigen::Matrix<float, Eigen::Dynamic, 2, Eigen::RowMajor>;

using PointsRef = Eigen::Ref<const Points>;
using TrianglesRef = Eigen::Ref<const Triangles>;

/// A similarity or rigid motion: x -> scale * rotation * x + translation.
struct Similarity {
    Matrix3 rotation = Matrix3::Identity();
    Vector3 translation = Vector3::Zero();
    double scale = 1.0;

    Vector3 apply(const Vector3& point) const { return scale * (rotation * point) + translation; }
    // Exactly Points: an Eigen matrix of any shape would convert to Vector3 as readily as to a Ref.
    Points apply(const Points& points) const { return apply(PointsRef(points)); }
    Points apply(const PointsRef& points) const {
        Points moved = (scale * points * rotation.transpose()).rowwise() + translation.transpose();
        return moved;
    }
    Similarity inverse() const {
        Similarity inverted;
        inverted.scale = 1.0 / scale;
        inverted.rotation = rotation.transpose();
        inverted.translation = -inverted.scale * (inverted.rotation * translation);
        return inverted;
    }
};

// First `inner`, then `outer`.
inline Similarity compose(const Similarity& outer, const Similarity& inner) {
    return {outer.rotation * inner.rotation, outer.apply(inner.translation),
            outer.scale * inner.scale};
}

}  // namespace mien
