// Stage 7, verdict: is the fit to be trusted? Plain measures of it, limits on them, and the reasons
// in words: a scan that is no face must not come back as a silent wrong mesh.
#pragma once

#include <string>
#include <vector>

#include "registration/expected_error.hpp"

namespace mien {

struct Verdict {
    FitQuality quality = FitQuality::good;
    std::vector<std::string> reasons;  ///< why not good; empty when it is
    double coverage = 0;      ///< share of the template's inner vertices with a scan beside them
    double inlier_share = 0;  ///< of those beside the scan: within three noise levels
    double mean_residual_mm = 0;  ///< of the inliers
    double landmark_rms_mm = 0;   ///< of the landmarks used; 0 without
    int landmarks_used = 0;
    std::vector<std::string> landmarks_rejected;
    double size_ratio = 1;      ///< fitted size over template size
    double mean_deviation = 0;  ///< of the coefficients, in standard deviations of the prior
    int flipped_triangles = 0;  ///< against the smooth fit
    int repaired_triangles = 0;
    int self_intersections = 0;      ///< pairs of crossing triangles (lips, lids)
    double search_score = 0;         ///< of a start without landmarks, 0 to 1; 0 with
    bool searched = false;           ///< the start was searched
    std::string two_surfaces;        ///< why the scan is not one surface; empty when it is
    bool turned_over = false;        ///< the scan's triangles face inwards
    int turned_triangles = 0;        ///< wound against the others, and mended
    std::vector<std::string> notes;  ///< what was mended or settled before the fit; no doubts
    double unit_to_mm = 1;           ///< what one unit of the scan was taken for
    std::vector<ColorAgreement>
        colors;  ///< of lips and brows; empty when the scan has no colours or the model no names
    bool may_slide = false;  ///< fewer than three landmarks and no trained mode say where along the
                             ///< skin a place is
    WholeMeasures whole;
    std::vector<ZoneMeasures> zones;  ///< the whole face first; empty when read from a file that
                                      ///< has none
    std::vector<ExpectedError> expected;       ///< one for each of `zones`
    std::vector<std::string> colors_left_out;  ///< features whose colours did not lie as they do
};

/// How the measures are taken. Tags in brackets: registration/settings.hpp.
struct MeasureSettings {
    double near_sigmas = 3;       ///< > 0: inliers, in noise levels [J]
    double least_sigma_mm = 0.5;  ///< mm, > 0: of at least so much [J]
    double beside_mm = 10;        ///< mm, > 0: vertices farther from the scan are not beside it [J]
    double no_residual_mm = 1e3;  ///< mm: stands for the residual of a fit without inliers, which
                                  ///< thereby fails
    ZoneMeasureSettings zones;
};

/// Limits beyond which a fit has failed, or is doubtful, whatever error is expected of it: no
/// simulated fit stands for all that is no face. [J]: right fits of the twelve simulated scans and
/// two real ones stay clear of them, fits to a ball and to half a face do not.
struct VerdictLimits {
    double doubtful_coverage = 0.2, failed_coverage = 0.12;
    double doubtful_inliers = 0.6, failed_inliers = 0.5;
    double doubtful_residual_mm = 0.8, failed_residual_mm = 1.6;
    double doubtful_landmark_mm = 8, failed_landmark_mm = 12;
    double doubtful_size = 0.25, failed_size = 0.35;  ///< |log(size_ratio)|
    double doubtful_deviation = 2.5, failed_deviation = 5;
    int doubtful_flipped = 100, failed_flipped = 400;
    /// Right poses score 0.54 to 0.95, balls, halves and backs of heads 0.27 to 0.54.
    double doubtful_search = 0.56, failed_search = 0.52;
    /// Between the two: mm expected of the face from which the fit has failed. Half a face that is
    /// fitted somewhere expects 4 mm and more, a lower face at its place 2 mm.
    double failed_search_mm = 3;
    std::size_t most_zones = 3;  ///< zones named in the reasons, the worst first
};

struct VerdictSettings {
    MeasureSettings measure;
    VerdictLimits limits;
};

/// Fills coverage, residuals, landmarks, size, deviation, may_slide and the measures of the whole
/// and of the zones. Reads the verdict's colours and folds. `landmark_sigma_mm`: as stated.
void measure_fit(const MeasuredFit& finished, double landmark_sigma_mm,
                 const MeasureSettings& settings, const Context& context, Verdict& verdict);

/// Sets the expected errors, quality and reasons from the measures. The quality is that of the
/// error expected of the whole face; doubtful at best where that of a zone is failed; and limits
/// that the whole stays within. No zone is good where the fit failed or the scan as a whole is
/// doubted.
void judge(Verdict& verdict, const VerdictLimits& limits);

/// What speaks against the scan as a whole speaks against each of its zones: none stays good.
void doubt_zones(Verdict& verdict);

}  // namespace mien
