#include "registration/shifted_landmarks.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>

namespace mien {
namespace {

Points misfits(const std::vector<Pin>& pins, const Points& places) {
    Points off(static_cast<Index>(pins.size()), 3);
    for (std::size_t k = 0; k < pins.size(); ++k)
        off.row(static_cast<Index>(k)) =
            pins[k].place.transpose() - places.row(static_cast<Index>(pins[k].vertex));
    return off;
}

// The two directions in which the landmarks reach farthest, about their middle.
struct Spread {
    Eigen::RowVector3d middle;
    Matrix3 directions;  // columns, the farthest last
};

Spread spread_of(const std::vector<Pin>& pins) {
    Points at(static_cast<Index>(pins.size()), 3);
    for (std::size_t k = 0; k < pins.size(); ++k)
        at.row(static_cast<Index>(k)) = pins[k].place.transpose();
    const Eigen::RowVector3d middle = at.colwise().mean();
    const Points off = at.rowwise() - middle;
    const Matrix3 moments = off.transpose() * off;
    return {middle, Eigen::SelfAdjointEigenSolver<Matrix3>(moments).eigenvectors()};
}

// The least share of `mean` that landmarks on one side of their middle show.
double least_half(const std::vector<Pin>& pins, const Points& off, const Vector3& mean) {
    const Spread spread = spread_of(pins);
    double least = 1;
    for (const int axis : {1, 2})
        for (const double side : {-1.0, 1.0}) {
            Vector3 sum = Vector3::Zero();
            Index count = 0;
            for (std::size_t k = 0; k < pins.size(); ++k) {
                const Vector3 from = pins[k].place - spread.middle.transpose();
                if (!(side * from.dot(spread.directions.col(axis)) > 0)) continue;
                sum += off.row(static_cast<Index>(k)).transpose();
                ++count;
            }
            if (count == 0) return 0;
            least =
                std::min(least, sum.dot(mean) / (static_cast<double>(count) * mean.squaredNorm()));
        }
    return least;
}

}  // namespace

Misfit misfit_of(const std::vector<Pin>& pins, const Points& places) {
    const Points off = misfits(pins, places);
    return {off.colwise().mean().transpose(), std::sqrt(off.rowwise().squaredNorm().mean())};
}

std::optional<Misfit> common_misfit(const std::vector<Pin>& pins, const Points& places,
                                    const ShiftedLandmarkSettings& settings) {
    if (pins.empty()) return std::nullopt;
    const Misfit all = misfit_of(pins, places);
    const double n = static_cast<double>(pins.size()), mean_mm = all.mean.norm();
    const bool clear =
        mean_mm >= settings.least_mm && mean_mm * std::sqrt(n) > settings.least_score * all.rms_mm;
    if (!clear || least_half(pins, misfits(pins, places), all.mean) < settings.least_half)
        return std::nullopt;
    return all;
}

ShiftSearch::ShiftSearch(const Misfit& found, const ShiftedLandmarkSettings& settings)
    : settings_(settings),
      found_(found),
      left_(found.mean),
      seen_(settings.seen_first),
      best_rms_mm_(settings.kept * found.rms_mm) {
    step();
}

void ShiftSearch::step() {
    step_ = left_ / seen_;
    shift_ += step_;
}

bool ShiftSearch::take(const Misfit& left) {
    const bool best =
        left.rms_mm < best_rms_mm_ && left.mean.norm() < settings_.kept_mean * found_.mean.norm();
    if (best) best_rms_mm_ = left.rms_mm;
    const double followed = (left_ - left.mean).dot(step_) / std::max(step_.squaredNorm(), 1e-300);
    seen_ = std::clamp(followed, settings_.seen_least, 1.0);
    left_ = left.mean;
    if (!settled()) step();
    return best;
}

bool ShiftSearch::settled() const {
    return left_.norm() < settings_.settled_mm;
}

}  // namespace mien
