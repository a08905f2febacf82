// Written by tests/bench/verdict_fits.py learn; do not edit. 156 fits of 30 people, seeds ict-3001,
// ict-3002, mh-3001, mh-3002 of verdict_cases.py, by kernel and trained models of two populations.
#include "registration/expected_error.hpp"

namespace mien {
namespace {

ErrorTable face_table() {
    using M = FitMeasure;
    ErrorTable table;
    table.constant = -0.678323;
    table.curves = {
        {M::residual_mm, 0.107312, {0.082062, 0.123454, 0.27416}, {0, 0.00467486, 0.346731}},
        {M::open_mm, 0.329688, {0.257024, 0.354402, 0.703028}, {0, 0.0785284, 0.76539}},
        {M::turn, 0.0271518, {0.021164, 0.034441, 0.20949}, {0, 0.114426, 0.303081}},
        {M::deviation_mm, 1.03811, {0.86513, 1.28591, 4.2898}, {0, 0.431966, 0.47076}},
        {M::stretch, 0.14835, {0.093196, 0.149612, 0.25938}, {0, 0.109344, 0.163529}},
        {M::search_miss, 0, {0, 0.473782}, {0, 0.263338}},
        {M::landmark_misfit, 1.19889, {0, 1.1561, 3.32488}, {0, 0, 0.277448}},
        {M::color_miss, 0.321327, {0.022485, 1, 1.23585}, {0, 0.258206, 0.258206}},
        {M::trained_deviation, 0.65988, {0, 0.613217, 1.0873}, {0, 0, 0.161053}},
        {M::kernel_deviation, 0.259365, {0.13094, 0.259365, 0.466892}, {0, 0.0557499, 0.238052}},
        {M::size, 0.0277959, {0.008769, 0.036893, 0.173949}, {0, 0.0635449, 0.305234}},
        {M::folds, 0, {0, 0.0005}, {0, 0.271503}},
        {M::is_free, 0, {0, 1}, {0, 0.155238}},
        {M::is_trained, 1, {0, 1}, {0, -0.0823072}},
    };
    table.at_mm = {0.975432, 1.32148, 1.81615, 2.60128, 4.40835};
    table.low = {-0.246669, -0.329765, -0.374569, -0.444188, -0.306209};
    table.high = {0.390797, 0.379442, 0.442972, 0.410609, 1.51867};
    return table;
}

ErrorTable zone_table() {
    using M = FitMeasure;
    ErrorTable table;
    table.constant = -0.334222;
    table.curves = {
        {M::face_mm, 1.24878, {0.891571, 1.47717, 4.46207}, {0, 0.16025, 0.933632}},
        {M::residual_mm, 0.0996481, {0.06417, 0.112582, 0.369548}, {0, 0.0430975, 0.482981}},
        {M::open_mm, 0.322868, {0.215323, 0.346598, 0.960493}, {0, 0.10001, 0.585554}},
        {M::turn, 0.0192895, {0.002609, 0.022167, 0.224024}, {0, 0, 0.0570916}},
        {M::deviation_mm, 0.984667, {0.775414, 1.15156, 4.44632}, {0, 0.213514, 0.700424}},
        {M::is_free, 0, {0, 1}, {0, 0.0941995}},
    };
    table.at_mm = {0.895118, 1.13324, 1.51857, 2.16693, 4.09906};
    table.low = {-0.482789, -0.580162, -0.516473, -0.600207, -0.605143};
    table.high = {0.630598, 0.563446, 0.560449, 0.602272, 1.83815};
    return table;
}

}  // namespace

const ErrorTables& learned_error_tables() {
    static const ErrorTables tables{face_table(), zone_table(), 1.55819, 5, 0.993999, 5};
    return tables;
}

}  // namespace mien
