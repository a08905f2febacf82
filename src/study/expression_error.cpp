#include "study/expression_error.hpp"

#include <algorithm>
#include <cmath>

namespace mien {

ExpressionError::ExpressionError(const Matrix& map, const NeutralFaces& faces, std::size_t first,
                                 std::size_t second, const Points& normals)
    : map_(map), num_vertices_(normals.rows()) {
    const VisitsResult& joint = faces.joint;
    const Index q = map.cols(), a = static_cast<Index>(first) * q,
                b = static_cast<Index>(second) * q;
    change_ = joint.expressions[second] - joint.expressions[first];
    spread_ = joint.covariance.block(a, a, q, q) + joint.covariance.block(b, b, q, q) -
              joint.covariance.block(a, b, q, q) - joint.covariance.block(b, a, q, q);
    // A displacement d of the training's frame is scale R d in the face's: g . scale R d.
    rotation_ = joint.poses[first].scale * joint.poses[first].rotation.transpose();
    along_normal_.resize(map.rows() / 3, q);
    for (Index v = 0; v < along_normal_.rows(); ++v)
        along_normal_.row(v) =
            (rotation_ * normals.row(v).transpose()).transpose() * map.middleRows(3 * v, 3);
}

ExpressionError::Part ExpressionError::of_slope(const Vector& slope) const {
    return {slope.dot(change_), std::sqrt(std::max(0.0, slope.dot(spread_ * slope)))};
}

ExpressionError::Part ExpressionError::of_loads(const Vector& loads) const {
    return of_slope(along_normal_.transpose() * loads.head(along_normal_.rows()));
}

ExpressionError::Part ExpressionError::of_slopes(const Points& slopes) const {
    Vector slope = Vector::Zero(map_.cols());
    for (Index v = 0; v < along_normal_.rows(); ++v)
        if (!slopes.row(v).isZero(0.0))
            slope +=
                map_.middleRows(3 * v, 3).transpose() * (rotation_ * slopes.row(v).transpose());
    return of_slope(slope);
}

Vector ExpressionError::normal_sd_mm(const ExpressionErrorSettings& settings) const {
    const Matrix product = along_normal_ * spread_;
    Vector sd = Vector::Zero(num_vertices_);
    for (Index v = 0; v < along_normal_.rows(); ++v) {
        const double variance = std::max(0.0, product.row(v).dot(along_normal_.row(v)));
        sd[v] = std::hypot(settings.posterior_factor * std::sqrt(variance),
                           settings.untrained_share * along_normal_.row(v).dot(change_));
    }
    return sd;
}

}  // namespace mien
