// Written by tests/bench/verdict_fits.py learn; do not edit. 155 fits of 30 people, seeds ict-3001,
// ict-3002, mh-3001, mh-3002 of verdict_cases.py, by kernel and trained models of two populations.
#include "registration/expected_error.hpp"

namespace mien {
namespace {

ErrorTable face_table() {
    using M = FitMeasure;
    ErrorTable table;
    table.constant = -0.707201;
    table.curves = {
        {M::residual_mm, 0.107312, {0.081988, 0.123931, 0.274562}, {0, 0.0350129, 0.37405}},
        {M::open_mm, 0.329688, {0.256505, 0.358134, 0.703965}, {0, 0.0682344, 0.734704}},
        {M::turn, 0.0271518, {0.021162, 0.034562, 0.210003}, {0, 0.099156, 0.293663}},
        {M::deviation_mm, 1.03811, {0.864951, 1.2811, 4.29401}, {0, 0.434875, 0.443827}},
        {M::stretch, 0.14835, {0.093017, 0.149684, 0.259514}, {0, 0.0991106, 0.162515}},
        {M::landmark_mm, 2.39779, {0, 2.31309, 6.65059}, {0, 0, 0.159152}},
        {M::search_miss, 0, {0, 0.474039}, {0, 0.280093}},
        {M::landmark_misfit, 1.19889, {0, 1.15654, 3.32529}, {0, 0, 0.159152}},
        {M::color_miss, 0.321327, {0.022789, 1, 1.23614}, {0, 0.280886, 0.280886}},
        {M::trained_deviation, 0.65988, {0, 0.620232, 1.08732}, {0, 0, 0.159664}},
        {M::kernel_deviation, 0.259365, {0.130888, 0.259819, 0.466926}, {0, 0.0655649, 0.261772}},
        {M::size, 0.0277959, {0.008698, 0.03651, 0.174058}, {0, 0.0657199, 0.27975}},
        {M::folds, 0, {0, 0.000512}, {0, 0.288678}},
        {M::is_free, 0, {0, 1}, {0, 0.160852}},
        {M::is_trained, 1, {0, 1}, {-0, -0.0723265}},
    };
    table.at_mm = {0.983282, 1.33252, 1.83691, 2.57075, 4.38147};
    table.low = {-0.217667, -0.325846, -0.371686, -0.445766, -0.323362};
    table.high = {0.378359, 0.337931, 0.455518, 0.412865, 1.51562};
    return table;
}

ErrorTable zone_table() {
    using M = FitMeasure;
    ErrorTable table;
    table.constant = -0.34648;
    table.curves = {
        {M::face_mm, 1.24924, {0.88901, 1.47839, 4.46739}, {0, 0.169421, 0.949886}},
        {M::residual_mm, 0.0996348, {0.065151, 0.113392, 0.370445}, {0, 0.0570279, 0.487478}},
        {M::open_mm, 0.322842, {0.216312, 0.347182, 0.962683}, {0, 0.0973544, 0.587744}},
        {M::turn, 0.0192441, {0.002609, 0.02256, 0.22469}, {0, 0, 0.0536189}},
        {M::deviation_mm, 0.982022, {0.772331, 1.14248, 4.21242}, {0, 0.208808, 0.661979}},
        {M::is_free, 0, {0, 1}, {0, 0.096415}},
    };
    table.at_mm = {0.890139, 1.12899, 1.51757, 2.17446, 4.1537};
    table.low = {-0.481359, -0.565418, -0.514026, -0.614352, -0.611812};
    table.high = {0.641864, 0.547924, 0.552117, 0.570447, 1.81091};
    return table;
}

}  // namespace

const ErrorTables& learned_error_tables() {
    static const ErrorTables tables{face_table(), zone_table(), 1.62498, 5, 0.991268, 5};
    return tables;
}

}  // namespace mien
