#include "registration/far_scan.hpp"

#include <algorithm>
#include <cmath>

namespace mien {

Vector3 far_origin(const PointsRef& vertices, const FarScanSettings& settings) {
    Vector3 first = Vector3::Zero(), sum = Vector3::Zero();
    double squares = 0, count = 0;
    for (Index i = 0; i < vertices.rows(); ++i) {
        if (!vertices.row(i).allFinite()) continue;
        if (count == 0) first = vertices.row(i).transpose();
        // From the first vertex: sums of squares of far coordinates would hold no spread.
        const Vector3 from_first = vertices.row(i).transpose() - first;
        sum += from_first;
        squares += from_first.squaredNorm();
        ++count;
    }
    if (count == 0) return Vector3::Zero();
    const Vector3 mean = sum / count;
    const double spread = std::sqrt(std::max(0.0, squares / count - mean.squaredNorm()));
    const Vector3 middle = first + mean;
    return middle.norm() > settings.spreads * spread ? middle : Vector3::Zero();
}

}  // namespace mien
