#include "registration/expected_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace mien {
namespace {

// Linear between knots, constant outside.
double value_at(const std::vector<double>& at, const std::vector<double>& value, double x) {
    if (at.empty()) return 0;
    if (!(x > at.front())) return value.front();
    for (std::size_t k = 1; k < at.size(); ++k)
        if (x < at[k])
            return value[k - 1] + (value[k] - value[k - 1]) * (x - at[k - 1]) / (at[k] - at[k - 1]);
    return value.back();
}

FitQuality quality_of(double expected_mm, double doubtful_mm, double failed_mm) {
    if (!(expected_mm <= failed_mm)) return FitQuality::failed;
    return expected_mm > doubtful_mm ? FitQuality::doubtful : FitQuality::good;
}

double log_error(const ErrorTable& table, const std::vector<double>& measures) {
    const std::size_t splits = (std::size_t{1} << table.depth) - 1, leaves = splits + 1;
    double sum = table.constant;
    for (std::size_t tree = 0; (tree + 1) * leaves <= table.leaves.size(); ++tree) {
        const std::uint8_t* split = table.splits.data() + 2 * splits * tree;
        std::size_t at = 0;
        while (at < splits) {
            const std::size_t input = split[2 * at], number = split[2 * at + 1];
            const std::vector<double>& limits = table.inputs[input].limits;
            // A measure without limits stands where a branch ended early: both sides are alike.
            const bool above = number < limits.size() && measures[input] > limits[number];
            at = 2 * at + (above ? 2 : 1);
        }
        sum += table.leaves[tree * leaves + at - splits] * table.leaf_unit;
    }
    return sum;
}

ExpectedError expect(const ErrorTable& table, const WholeMeasures& whole, const ZoneMeasures& zone,
                     double zones_mm) {
    ExpectedError error;
    error.zone = zone.name;
    std::vector<double> measures;
    for (const ErrorInput& input : table.inputs)
        measures.push_back(measure_of(input.measure, whole, zone, zones_mm));
    const double logarithm = log_error(table, measures);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < measures.size(); ++k) {
        if (table.inputs[k].measure == FitMeasure::zones_mm) continue;
        const double kept = measures[k];
        measures[k] = table.inputs[k].right;
        const double without = log_error(table, measures);
        if (without < least) least = without, error.cause = table.inputs[k].measure;
        measures[k] = kept;
    }
    error.expected_mm = std::exp(logarithm);
    error.low_mm =
        error.expected_mm * std::exp(value_at(table.at_mm, table.low, error.expected_mm));
    error.high_mm =
        error.expected_mm * std::exp(value_at(table.at_mm, table.high, error.expected_mm));
    return error;
}

const char* words_of(FitMeasure cause) {
    switch (cause) {
        case FitMeasure::unseen:
        case FitMeasure::worst_unseen:
            return "the scan does not show enough of it: scan the whole face, uncovered";
        case FitMeasure::residual_mm:
        case FitMeasure::open_mm:
        case FitMeasure::open_most_mm:
        case FitMeasure::worst_open_mm:
            return "the scan lies off the model's shape there: is something in front of the skin, "
                   "or the face unlike those that the model knows? Landmarks would help";
        case FitMeasure::turn:
            return "its surface faces otherwise than the scan's: pick landmarks there";
        case FitMeasure::deviation_mm:
        case FitMeasure::is_free:
        case FitMeasure::is_trained:
        case FitMeasure::kernel_mm:
        case FitMeasure::slid_mm:
        case FitMeasure::pin_far_mm:
        case FitMeasure::color_hold:
            return "little tells where along the skin its places are: pick landmarks there, or use "
                   "a trained model";
        case FitMeasure::stretch:
            return "it is stretched unlike a face: check the landmarks, or pick more";
        case FitMeasure::landmark_mm:
        case FitMeasure::landmark_misfit:
        case FitMeasure::landmarks_out:
        case FitMeasure::pin_misfit_mm:
            return "the landmarks and the surface disagree: check how they were picked, and the "
                   "stated picking error";
        case FitMeasure::search_miss:
            return "no pose agrees well with a face: is this one, whole and in the right unit? "
                   "Landmarks would tell";
        case FitMeasure::color_miss:
        case FitMeasure::color_doubt:
        case FitMeasure::lips_miss:
        case FitMeasure::brows_miss:
            return "brows or lips are not seen where the form has them: make-up, light, or a wrong "
                   "fit; landmarks would tell";
        case FitMeasure::no_colors:
            return "no colours tell where brows and lips are: landmarks there would";
        case FitMeasure::trained_deviation:
        case FitMeasure::kernel_deviation:
        case FitMeasure::size:
        case FitMeasure::shape_deviation:
        case FitMeasure::asymmetry_mm:
            return "the shape is unlike those that the model knows: check the unit, the landmarks "
                   "and the model";
        case FitMeasure::folds:
            return "triangles are folded over: check the landmarks and the scan";
        case FitMeasure::zones_mm:
        case FitMeasure::count:
            return "the whole fit is doubtful";
    }
    return "";
}

}  // namespace

double measure_of(FitMeasure measure, const WholeMeasures& whole, const ZoneMeasures& zone,
                  double zones_mm) {
    switch (measure) {
        case FitMeasure::unseen:
            return zone.unseen;
        case FitMeasure::residual_mm:
            return zone.residual_mm;
        case FitMeasure::open_mm:
            return zone.open_mm;
        case FitMeasure::turn:
            return zone.turn;
        case FitMeasure::deviation_mm:
            return zone.deviation_mm;
        case FitMeasure::stretch:
            return zone.stretch;
        case FitMeasure::landmark_mm:
            return zone.landmark_mm;
        case FitMeasure::search_miss:
            return whole.search_miss;
        case FitMeasure::landmark_misfit:
            return whole.landmark_misfit;
        case FitMeasure::landmarks_out:
            return whole.landmarks_out;
        case FitMeasure::color_miss:
            return whole.color_miss;
        case FitMeasure::trained_deviation:
            return whole.trained_deviation;
        case FitMeasure::kernel_deviation:
            return whole.kernel_deviation;
        case FitMeasure::kernel_mm:
            return whole.kernel_mm;
        case FitMeasure::size:
            return whole.size;
        case FitMeasure::folds:
            return whole.folds;
        case FitMeasure::is_free:
            return whole.is_free;
        case FitMeasure::is_trained:
            return whole.is_trained;
        case FitMeasure::no_colors:
            return whole.no_colors;
        case FitMeasure::zones_mm:
            return zones_mm;
        case FitMeasure::open_most_mm:
            return zone.open_most_mm;
        case FitMeasure::asymmetry_mm:
            return zone.asymmetry_mm;
        case FitMeasure::shape_deviation:
            return zone.shape_deviation;
        case FitMeasure::slid_mm:
            return zone.slid_mm;
        case FitMeasure::pin_far_mm:
            return zone.pin_far_mm;
        case FitMeasure::pin_misfit_mm:
            return zone.pin_misfit_mm;
        case FitMeasure::color_hold:
            return zone.color_hold;
        case FitMeasure::color_doubt:
            return zone.color_doubt;
        case FitMeasure::lips_miss:
            return whole.lips_miss;
        case FitMeasure::brows_miss:
            return whole.brows_miss;
        case FitMeasure::worst_open_mm:
            return whole.worst_open_mm;
        case FitMeasure::worst_unseen:
            return whole.worst_unseen;
        case FitMeasure::count:
            break;
    }
    return 0;
}

std::vector<ExpectedError> expect_errors(const WholeMeasures& whole,
                                         const std::vector<ZoneMeasures>& zones,
                                         const ErrorTables& tables) {
    if (zones.empty()) return {};
    std::vector<ExpectedError> errors(zones.size());
    double sum = 0;
    for (std::size_t k = 1; k < zones.size(); ++k) {
        errors[k] = expect(tables.zone, whole, zones[k], 0);
        errors[k].quality =
            quality_of(errors[k].expected_mm, tables.zone_doubtful_mm, tables.zone_failed_mm);
        sum += errors[k].expected_mm;
    }
    // A model without zones: the face is the one that it has.
    const double zones_mm = zones.size() > 1
                                ? sum / static_cast<double>(zones.size() - 1)
                                : expect(tables.zone, whole, zones.front(), 0).expected_mm;
    errors.front() = expect(tables.face, whole, zones.front(), zones_mm);
    errors.front().quality =
        quality_of(errors.front().expected_mm, tables.face_doubtful_mm, tables.face_failed_mm);
    return errors;
}

std::string reason_of(const ExpectedError& error) {
    char text[64];
    std::snprintf(text, sizeof text, "about %.1f mm (%.1f to %.1f) off are expected of the ",
                  error.expected_mm, error.low_mm, error.high_mm);
    return text + error.zone + ": " + words_of(error.cause);
}

}  // namespace mien
