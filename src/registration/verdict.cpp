#include "registration/verdict.hpp"

#include <cmath>
#include <cstdio>

namespace mien {
namespace {

class Judge {
  public:
    explicit Judge(Verdict& verdict) : verdict_(verdict) {}

    // value beyond `failed` fails, beyond `doubtful` is doubted; `below` turns the comparison
    // round.
    void limit(double value, double doubtful, double failed, bool below, const char* text) {
        const auto beyond = [&](double bound) {
            return below ? !(value >= bound) : !(value <= bound);
        };
        if (!beyond(doubtful)) return;
        const FitQuality found = beyond(failed) ? FitQuality::failed : FitQuality::doubtful;
        if (found > verdict_.quality) verdict_.quality = found;
        char reason[200];
        std::snprintf(reason, sizeof reason, text, value);
        verdict_.reasons.emplace_back(reason);
    }

  private:
    Verdict& verdict_;
};

}  // namespace

void judge(Verdict& v, const VerdictLimits& l) {
    v.quality = FitQuality::good;
    v.reasons.clear();
    Judge judge(v);
    judge.limit(v.coverage, l.doubtful_coverage, l.failed_coverage, true,
                "the scan covers only a share of %.2f of the template");
    judge.limit(v.inlier_share, l.doubtful_inliers, l.failed_inliers, true,
                "only a share of %.2f of the fitted vertices lies on the scan");
    judge.limit(v.mean_residual_mm, l.doubtful_residual_mm, l.failed_residual_mm, false,
                "the fitted surface stays %.2f mm away from the scan on average");
    judge.limit(v.landmark_rms_mm, l.doubtful_landmark_mm, l.failed_landmark_mm, false,
                "the landmarks end %.1f mm from the fitted ones");
    judge.limit(std::abs(std::log(v.size_ratio)), l.doubtful_size, l.failed_size, false,
                "the size is implausible (logarithm of the ratio to the template: %.2f)");
    judge.limit(v.mean_deviation, l.doubtful_deviation, l.failed_deviation, false,
                "the shape is implausible (%.1f standard deviations of the prior)");
    judge.limit(v.flipped_triangles, l.doubtful_flipped, l.failed_flipped, false,
                "%.0f triangles are folded over");
    if (v.may_slide) {
        if (v.quality == FitQuality::good) v.quality = FitQuality::doubtful;
        bool held = !v.colors.empty();
        for (const ColorAgreement& feature : v.colors)
            held = held && feature.correlation >= l.doubtful_color;
        v.reasons.emplace_back(held ? "neither landmarks nor trained modes tell where along the "
                                      "skin a place is: colours hold mouth and brows, "
                                      "but cheeks and chin may have slid by some millimetres"
                                    : "neither landmarks nor trained modes tell where along the "
                                      "skin mouth, brows and cheeks are: "
                                      "the surface is right, but its vertices may have slid along "
                                      "it by some millimetres");
    }
    if (!v.landmarks_rejected.empty()) {
        std::string names = "landmarks that contradict the others were left out:";
        for (const std::string& name : v.landmarks_rejected) names += " " + name;
        v.reasons.push_back(names);
    }
}

}  // namespace mien
