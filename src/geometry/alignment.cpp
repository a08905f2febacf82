#include "geometry/alignment.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

#include "base/error.hpp"

namespace mien {

Similarity align_points(const PointsRef& source, const PointsRef& target, const Vector& weights,
                        bool with_scale) {
    if (source.rows() != target.rows() || (weights.size() != 0 && weights.size() != source.rows()))
        fail(Status::mismatch, "alignment of %lld points with %lld points and %lld weights",
             static_cast<long long>(source.rows()), static_cast<long long>(target.rows()),
             static_cast<long long>(weights.size()));
    const Vector w = weights.size() != 0 ? weights : Vector::Ones(source.rows());
    const double total = w.sum();
    if (source.rows() < 3)
        fail(Status::no_solution, "alignment needs at least 3 points, got %lld",
             static_cast<long long>(source.rows()));
    if (!(w.minCoeff() >= 0))
        fail(Status::no_solution, "a weight of the alignment is below zero or not a number");
    if (!(total > 0))
        fail(Status::no_solution,
             "none of the %lld points to align has a weight above zero, as after a fit that failed",
             static_cast<long long>(source.rows()));

    const Eigen::RowVector3d source_centre = (w.transpose() * source) / total;
    const Eigen::RowVector3d target_centre = (w.transpose() * target) / total;
    const Points source_centred = source.rowwise() - source_centre;
    const Points target_centred = target.rowwise() - target_centre;
    const Matrix3 covariance = target_centred.transpose() * w.asDiagonal() * source_centred / total;
    const Eigen::JacobiSVD<Matrix3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    if (svd.info() != Eigen::Success)
        fail(Status::no_solution, "alignment points or weights are not finite");
    const Vector3& singular = svd.singularValues();
    if (!(singular[1] > 1e-12 * singular[0]) || !(singular[0] > 0))
        fail(Status::no_solution,
             "alignment points lie on one line; give points that span a plane");

    Vector3 signs(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1);
    Similarity motion;
    motion.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    if (with_scale) {
        const double spread =
            (w.asDiagonal() * source_centred.cwiseProduct(source_centred)).sum() / total;
        motion.scale = singular.dot(signs) / spread;
    }
    motion.translation =
        target_centre.transpose() - motion.scale * (motion.rotation * source_centre.transpose());
    return motion;
}

}  // namespace mien
