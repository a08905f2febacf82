#include "registration/settings.hpp"

#include <cmath>
#include <Eigen/LU>
#include <utility>

#include "base/error.hpp"

namespace mien {
namespace {

struct Number {
    const char* name;
    double value, least, most;
    bool open;  // `least` itself is not allowed
};

void check(const Number& number) {
    const bool above = number.open ? number.value > number.least : number.value >= number.least;
    if (above && number.value <= number.most && std::isfinite(number.value)) return;
    fail(Status::invalid_argument, "registration: %s is %g, it must be %s %g and at most %g",
         number.name, number.value, number.open ? "above" : "at least", number.least, number.most);
}

void check_pose(const Similarity& pose) {
    constexpr double kSlack = 1e-3;  // what a matrix written with a few digits is off by
    const Matrix3& r = pose.rotation;
    if (!r.allFinite() || !pose.translation.allFinite() || !(pose.scale > 0) ||
        !std::isfinite(pose.scale) ||
        (r * r.transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff() > kSlack ||
        r.determinant() < 0)
        fail(Status::invalid_argument,
             "registration: the pose's rotation is not a rotation, or its numbers are not finite");
}

}  // namespace

void check_settings(const RegistrationSettings& s) {
    constexpr double kHuge = 1e30;
    const LoopSettings& loop = s.fit.loop;
    const EvidenceSettings& evidence = loop.evidence;
    for (const Number& number : {
             Number{"far spreads", s.far.spreads, 0, kHuge, true},
             Number{"landmark_sigma_mm", s.start.landmark_sigma_mm, 0, kHuge, true},
             Number{"sigma_start_mm", loop.sigma_start_mm, 0, kHuge, true},
             Number{"sigma_end_mm", loop.sigma_end_mm, 0, kHuge, true},
             Number{"robust_factor", loop.robust_factor, 0, kHuge, true},
             Number{"pca_amplitude", s.prior.pca_amplitude, 0, kHuge, true},
             Number{"least_open_mm", s.span.least_open_mm, 0, kHuge, false},
             Number{"kernel_share", s.span.kernel_share, 0, 1, false},
             Number{"shifted least_score", s.shifted.least_score, 0, kHuge, true},
             Number{"shifted least_half", s.shifted.least_half, 0, 1, false},
             Number{"shifted least_mm", s.shifted.least_mm, 0, kHuge, true},
             Number{"shifted most_fits", static_cast<double>(s.shifted.most_fits), 1, 100, false},
             Number{"shifted seen_first", s.shifted.seen_first, 0, 1, true},
             Number{"shifted seen_least", s.shifted.seen_least, 0, 1, true},
             Number{"shifted settled_mm", s.shifted.settled_mm, 0, kHuge, false},
             Number{"shifted kept_mean", s.shifted.kept_mean, 0, 1, false},
             Number{"shifted kept", s.shifted.kept, 0, 1, false},
             Number{"least_seen", s.span.least_seen, 0, 1, false},
             Number{"kernel_amplitude", s.prior.kernel_amplitude, 0, kHuge, false},
             Number{"max_angle_deg", loop.match.max_angle_deg, 0, kHuge, true},
             Number{"soft_mm", loop.match.soft_mm, 0, kHuge, false},
             Number{"normal_length_mm", evidence.bend.normal_length_mm, 0, kHuge, false},
             Number{"surface weight", evidence.surface.weight, 0, kHuge, true},
             Number{"tangential", evidence.surface.tangential, 0, 1, false},
             Number{"iterations", static_cast<double>(loop.rounds), 1, 10000, false},
             Number{"sparse_share", loop.sparse_share, 0, 1, false},
             Number{"sparse_stride", static_cast<double>(loop.sparse_stride), 1, kHuge, false},
             Number{"smoothing_mm", s.intake.surface.smoothing_mm, 0, kHuge, false},
             Number{"gap smoothness", s.gap.field.smoothness, 0, kHuge, true},
             Number{"gap rounds", static_cast<double>(s.gap.rounds), 1, 10000, false},
             Number{"max_turn_rad", s.folds.max_turn_rad, 0, 3.2, true},
         })
        check(number);
    for (const auto& [name, value] : {std::pair{"max_distance_mm", loop.match.limit_mm},
                                      std::pair{"mutual_mm", loop.match.mutual_mm}})
        if (!(value > 0))  // infinite: not asked
            fail(Status::invalid_argument, "registration: %s is %g, it must be above 0", name,
                 value);
    if (s.start.kind == StartKind::pose) check_pose(s.start.pose);
}

}  // namespace mien
