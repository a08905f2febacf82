#include "registration/fit_terms.hpp"

namespace mien {
namespace {

Eigen::Matrix<float, 1, 6> pack(const Matrix3& h) {
    const Eigen::Matrix<double, 1, 6> packed{h(0, 0), h(1, 1), h(2, 2), h(0, 1), h(0, 2), h(1, 2)};
    return packed.cast<float>();
}

}  // namespace

void FitTerms::reset(Index num_rows) {
    precision.setZero(num_rows, 6);
    pull.setZero(num_rows, 3);
}

void FitTerms::add(Index row, const Matrix3& h, const Vector3& pulled) {
    precision.row(row) += pack(h);
    pull.row(row) += pulled.cast<float>().transpose();
}

void FitTerms::add_isotropic(Index row, double weight, const Vector3& target_displacement) {
    precision.row(row).head<3>().array() += static_cast<float>(weight);
    pull.row(row) += (weight * target_displacement).cast<float>().transpose();
}

void FitTerms::add_planar(Index row, double weight, double tau, const Vector3& normal,
                          const Vector3& target_displacement) {
    const Matrix3 h =
        weight * ((1 - tau) * normal * normal.transpose() + tau * Matrix3::Identity());
    add(row, h, h * target_displacement);
}

}  // namespace mien
