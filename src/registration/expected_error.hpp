// How far is a fit from the truth, in mm? Learned from many simulated fits whose truth is known
// (tests/bench/verdict_fits.py makes them and writes expected_error_table.cpp):
//
//   log e = constant + sum of boosted trees of the measures (fit_measures.hpp)
//
// one sum for the zones and one for the face, among whose measures is the mean of what is expected
// of its zones.
// Trees, because measures speak together: far from any landmark means little where colours agree.
// All but a few measures are held to one direction, so that more of a trouble never makes the
// expectation smaller. The range is what held 8 of 10 training fits with a like expectation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "registration/fit_measures.hpp"

namespace mien {

/// The numbers are the C ABI's numbers.
enum class FitQuality : std::int32_t { good = 0, doubtful = 1, failed = 2 };

/// What a tree of the table looks at.
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
    zones_mm,  ///< what is expected of its zones in the mean; 0 for a zone
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
    FitMeasure cause = FitMeasure::deviation_mm;  ///< which, were it as in right fits, would
                                                  ///< lower it most
};

/// A measure of the table: where trees split it, and its middle among right fits.
struct ErrorInput {
    FitMeasure measure;
    double right;
    std::vector<double> limits;  ///< ascending
};

/// log error = constant + sum of trees. A full tree of a depth D has 2^D - 1 splits and 2^D leaves;
/// from split k it goes on at 2 k + 1, or at 2 k + 2 where the measure is above the limit.
struct ErrorTable {
    double constant;
    int depth;
    double leaf_unit;  ///< of the logarithm
    std::vector<ErrorInput> inputs;
    std::vector<std::uint8_t> splits;  ///< tree after tree: input, number of its limit
    std::vector<std::int16_t> leaves;  ///< tree after tree, in leaf_unit
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
                  double zones_mm);

/// One for each of `zones`, whose first is the whole face.
std::vector<ExpectedError> expect_errors(const WholeMeasures& whole,
                                         const std::vector<ZoneMeasures>& zones,
                                         const ErrorTables& tables);

/// The cause in words, and what to do about it.
std::string reason_of(const ExpectedError& error);

}  // namespace mien
