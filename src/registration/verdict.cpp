#include "registration/verdict.hpp"

#include <algorithm>
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
        char reason[200];
        std::snprintf(reason, sizeof reason, text, value);
        doubt(beyond(failed) ? FitQuality::failed : FitQuality::doubtful, reason);
    }

    void doubt(FitQuality found, std::string reason) {
        if (found > verdict_.quality) verdict_.quality = found;
        verdict_.reasons.push_back(std::move(reason));
    }

  private:
    Verdict& verdict_;
};

// Root mean square distance to the mean.
double spread(const Points& points) {
    const Eigen::RowVector3d mean = points.colwise().mean();
    return std::sqrt((points.rowwise() - mean).rowwise().squaredNorm().mean());
}

// Of the coefficients, in prior deviations: the larger of the trained modes' and the kernel's.
double mean_deviation(const FitState& state) {
    const FitCoefficients& c = state.coefficients;
    double deviation = 0;
    if (c.pca.size() > 0)
        deviation = std::sqrt(c.pca.squaredNorm() / static_cast<double>(c.pca.size()));
    if (c.kernel.size() > 0)
        deviation = std::max<double>(deviation, std::sqrt(state.kernel_off().squaredNorm() /
                                                          static_cast<double>(c.kernel.size())) /
                                                    state.kernel_amplitude);
    return deviation;
}

// Coverage, share of inliers and their mean distance.
void measure_surface(const MeasuredFit& finished, const MeasureSettings& settings, Verdict& v) {
    const Index n = finished.places.rows();
    const double near =
        settings.near_sigmas * std::max(finished.fit.trace.sigma_mm, settings.least_sigma_mm);
    Index beside = 0, inliers = 0;
    double residual = 0;
    for (Index i = 0; i < n; ++i) {
        const SurfaceHit& hit = finished.correspondence[static_cast<std::size_t>(i)];
        if (!hit.valid() || finished.start.scan.surface().at_border(hit) ||
            hit.distance() > settings.beside_mm)
            continue;
        if (finished.prior.inner[static_cast<std::size_t>(i)]) continue;
        ++beside;
        if (hit.distance() > near || !(finished.fit.trace.weight[i] > 0)) continue;
        ++inliers;
        residual += hit.distance();
    }
    v.coverage = static_cast<double>(beside) / static_cast<double>(n);
    v.inlier_share = beside > 0 ? static_cast<double>(inliers) / static_cast<double>(beside) : 0;
    v.mean_residual_mm =
        inliers > 0 ? residual / static_cast<double>(inliers) : settings.no_residual_mm;
}

// The whole face decides. Zones are named, the worst first, where it is not good, or they failed.
void judge_expected(Verdict& v, std::size_t most_zones, Judge& judge) {
    v.expected = expect_errors(v.whole, v.zones, learned_error_tables());
    std::vector<const ExpectedError*> zones;
    for (const ExpectedError& error : v.expected) {
        if (error.quality == FitQuality::good) continue;
        if (&error == &v.expected.front())
            judge.doubt(error.quality, reason_of(error));
        else
            zones.push_back(&error);
    }
    std::stable_sort(zones.begin(), zones.end(),
                     [](const ExpectedError* a, const ExpectedError* b) {
                         return a->expected_mm > b->expected_mm;
                     });
    const bool good = v.quality == FitQuality::good;
    const auto minor = [good](const ExpectedError* error) {
        return good && error->quality != FitQuality::failed;
    };
    zones.erase(std::remove_if(zones.begin(), zones.end(), minor), zones.end());
    for (std::size_t k = 0; k < std::min(zones.size(), most_zones); ++k)
        judge.doubt(
            zones[k]->quality == FitQuality::failed ? FitQuality::doubtful : FitQuality::good,
            reason_of(*zones[k]));
}

}  // namespace

void measure_fit(const MeasuredFit& finished, double landmark_sigma_mm,
                 const MeasureSettings& settings, const Context& context, Verdict& v) {
    measure_surface(finished, settings, v);
    const std::vector<Pin>& pins = finished.start.pins;
    double squares = 0;
    for (const Pin& pin : pins)
        squares += (finished.places.row(pin.vertex).transpose() - pin.place).squaredNorm();
    v.landmarks_used = static_cast<int>(pins.size());
    v.landmark_rms_mm = pins.empty() ? 0 : std::sqrt(squares / static_cast<double>(pins.size()));
    v.size_ratio = spread(finished.places) / spread(finished.model.template_mesh.vertices);
    v.mean_deviation = mean_deviation(finished.fit.state);
    v.may_slide = finished.start.is_free() && finished.prior.pca_modes == 0;
    v.whole = measure_whole(finished, landmark_sigma_mm);
    v.whole.no_colors = v.colors.empty() ? 1 : 0;
    for (const ColorAgreement& feature : v.colors) {
        const double miss = 1 - feature.correlation;
        double& worst = feature.name == "lips" ? v.whole.lips_miss : v.whole.brows_miss;
        worst = std::max(worst, miss);
        v.whole.color_miss = std::max(v.whole.color_miss, miss);
    }
    v.whole.folds = static_cast<double>(v.flipped_triangles) /
                    static_cast<double>(finished.model.template_mesh.triangles.rows());
    v.zones = measure_zones(finished, v.colors, settings.zones, context);
    for (const ZoneMeasures& zone : v.zones) {
        v.whole.worst_open_mm = std::max(v.whole.worst_open_mm, zone.open_mm);
        v.whole.worst_unseen = std::max(v.whole.worst_unseen, zone.unseen);
    }
}

void doubt_zones(Verdict& v) {
    for (ExpectedError& error : v.expected)
        error.quality = std::max(error.quality, FitQuality::doubtful);
}

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
    if (v.searched)
        judge.limit(v.search_score, l.doubtful_search, l.failed_search, true,
                    "no face was found in any pose that agrees well enough (%.2f of 1): is this a "
                    "face, whole and in the right unit? Landmarks would tell");
    if (v.turned_over)
        judge.doubt(FitQuality::doubtful,
                    "the scan's triangles face inwards: it is inside out, or mirrored (left and "
                    "right exchanged)");
    if (!v.two_surfaces.empty()) judge.doubt(FitQuality::doubtful, v.two_surfaces);
    judge_expected(v, l.most_zones, judge);
    if (v.searched && !v.expected.empty() && !(v.search_score >= l.doubtful_search) &&
        v.expected.front().expected_mm > l.failed_search_mm)
        judge.doubt(
            FitQuality::failed,
            "neither the pose nor the fit is like that of a face: half a face, or none, lies "
            "anywhere; give landmarks");
    if (v.turned_over || !v.two_surfaces.empty() || v.quality == FitQuality::failed) doubt_zones(v);
    if (!v.colors_left_out.empty()) {
        std::string names = "colours that do not lie as the form does were left out:";
        for (const std::string& name : v.colors_left_out) names += " " + name;
        v.notes.push_back(names);
    }
    if (!v.landmarks_rejected.empty()) {
        std::string names = "landmarks that contradict the others were left out:";
        for (const std::string& name : v.landmarks_rejected) names += " " + name;
        v.reasons.push_back(names);
    }
}

}  // namespace mien
