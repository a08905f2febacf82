// How far is a fit from the truth, in mm? Learned from many simulated fits whose truth is known
// (tests/bench/verdict_fits.py makes them and writes expected_error_table.cpp):
//
//   log e_face = a + sum_k f_k(m_k),   log e_zone = b + sum_k g_k(m_k)
//
// m_k the measures of fit_measures.hpp, f_k and g_k monotone and linear between a few knots, so
// that more of any trouble never makes the prediction smaller. One of the zones' measures is the
// face's own expectation. The range is what held 8 of 10 training fits with a like expectation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "registration/fit_measures.hpp"

namespace mien {

/// The numbers are the C ABI's numbers.
enum class FitQuality : std::int32_t { good = 0, doubtful = 1, failed = 2 };

/// What a curve of the table looks at.
enum class FitMeasure {
    unseen,
    residual_mm,
    open_mm,
    turn,
    deviation_mm,
    stretch,
    landmark_mm,
    search_miss,
    landmark_misfit,
    landmarks_out,
    color_miss,
    trained_deviation,
    kernel_deviation,
    kernel_mm,
    size,
    folds,
    is_free,
    is_trained,
    no_colors,
    face_mm,  ///< what is expected of the whole face; 0 for the face itself
    open_most_mm,
    asymmetry_mm,
    shape_deviation,
    slid_mm,
    pin_far_mm,
    pin_misfit_mm,
    color_hold,
    color_doubt,
    lips_miss,
    brows_miss,
    worst_open_mm,
    worst_unseen,
    count,  ///< how many there are; fit records keep the numbers, so new ones go before it
};

/// Mean distance of a zone's vertices from the true ones.
struct ExpectedError {
    std::string zone;  ///< "face": the whole
    double expected_mm = 0;
    double low_mm = 0, high_mm = 0;  ///< 8 of 10 lie between
    FitQuality quality = FitQuality::good;
    FitMeasure cause = FitMeasure::deviation_mm;  ///< what raises it most above a right fit's
};

/// Linear between knots, constant outside.
struct ErrorCurve {
    FitMeasure measure;
    double right;  ///< the measure's middle among right fits
    std::vector<double> at, value;
};

struct ErrorTable {
    double constant;
    std::vector<ErrorCurve> curves;
    /// Of the logarithm of truth over expectation: tenth and ninetieth percentile, linear between
    /// expectations in mm.
    std::vector<double> at_mm, low, high;
};

struct ErrorTables {
    ErrorTable face, zone;
    /// mm, on the expectation: above, a face is doubtful or failed, and a zone.
    double face_doubtful_mm, face_failed_mm, zone_doubtful_mm, zone_failed_mm;
};

/// The learned ones (expected_error_table.cpp).
const ErrorTables& learned_error_tables();

/// Value of a measure.
double measure_of(FitMeasure measure, const WholeMeasures& whole, const ZoneMeasures& zone,
                  double face_mm);

/// One for each of `zones`, whose first is the whole face.
std::vector<ExpectedError> expect_errors(const WholeMeasures& whole,
                                         const std::vector<ZoneMeasures>& zones,
                                         const ErrorTables& tables);

/// The cause in words, and what to do about it.
std::string reason_of(const ExpectedError& error);

}  // namespace mien
