#include "measure/statistics_json.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "base/json_text.hpp"
#include "measure/icc.hpp"

namespace mien {
namespace {

void write_matrix(JsonText& json, const Matrix& m) {
    json.begin_array();
    for (Index i = 0; i < m.rows(); ++i) {
        json.begin_array();
        for (Index j = 0; j < m.cols(); ++j) json.number(m(i, j));
        json.end_array();
    }
    json.end_array();
}

void write_values(JsonText& json, const char* name, const Vector& values) {
    json.key(name);
    json.begin_array();
    for (Index i = 0; i < values.size(); ++i) json.number(values[i]);
    json.end_array();
}

void write_kappa(JsonText& json, const char* name, const Kappa& kappa) {
    json.key(name);
    json.begin_object();
    json.field("kappa", kappa.kappa);
    json.field("low95", kappa.low95);
    json.field("high95", kappa.high95);
    json.field("p_value", kappa.p_value);
    json.end_object();
}

void write_icc(JsonText& json, const char* name, const IntraclassCorrelation& icc) {
    json.key(name);
    json.begin_object();
    json.field("icc", icc.icc);
    json.field("f", icc.f);
    json.field("p_value", icc.p_value);
    json.field("low95", icc.low);
    json.field("high95", icc.high);
    json.end_object();
}

void write_all_icc(JsonText& json, const Ratings& ratings) {
    json.key("icc");
    std::vector<Index> complete;
    for (Index s = 0; s < ratings.rows(); ++s)
        if ((ratings.row(s).array() >= 0).all()) complete.push_back(s);
    Matrix scores(static_cast<Index>(complete.size()), ratings.cols());
    for (std::size_t i = 0; i < complete.size(); ++i)
        scores.row(static_cast<Index>(i)) = ratings.row(complete[i]).cast<double>();
    if (scores.rows() < 2 || (scores.array() == scores(0, 0)).all()) {
        json.null();
        return;
    }
    const IccReport icc = intraclass_correlation(scores);
    json.begin_object();
    write_icc(json, "icc1", icc.icc1);
    write_icc(json, "icc2", icc.icc2);
    write_icc(json, "icc3", icc.icc3);
    write_icc(json, "icc1k", icc.icc1k);
    write_icc(json, "icc2k", icc.icc2k);
    write_icc(json, "icc3k", icc.icc3k);
    json.end_object();
}

}  // namespace

std::string agreement_json(const Ratings& ratings, int num_grades) {
    if (ratings.cols() < 2 || ratings.rows() < 2)
        fail(Status::invalid_argument, "%lld subjects and %lld raters; agreement needs two of each",
             static_cast<long long>(ratings.rows()), static_cast<long long>(ratings.cols()));
    JsonText json;
    json.begin_object();
    json.field("subjects", static_cast<double>(ratings.rows()));
    json.field("raters", static_cast<double>(ratings.cols()));
    json.field("percent_agreement_all", percent_agreement(ratings, 0));
    json.field("percent_within_one_grade", percent_agreement(ratings, 1));
    const FleissKappa fleiss = fleiss_kappa(ratings, num_grades);
    json.key("fleiss");
    json.begin_object();
    json.field("kappa", fleiss.kappa);
    json.field("z", fleiss.z);
    json.field("p_value", fleiss.p_value);
    json.field("subjects", static_cast<double>(fleiss.num_subjects));
    write_values(json, "kappa_per_grade", fleiss.kappa_per_grade);
    json.end_object();
    write_all_icc(json, ratings);
    json.key("pairs");
    json.begin_array();
    for (Index a = 0; a < ratings.cols(); ++a)
        for (Index b = a + 1; b < ratings.cols(); ++b) {
            const Matrix counts = confusion_matrix(ratings, a, b, num_grades);
            json.begin_object();
            json.key("raters");
            json.begin_array();
            json.number(static_cast<double>(a));
            json.number(static_cast<double>(b));
            json.end_array();
            json.key("confusion");
            write_matrix(json, counts);
            json.field("percent_agreement", counts.trace() / counts.sum());
            if (counts.sum() > 0) {
                write_kappa(json, "kappa", cohen_kappa(counts, KappaWeights::unweighted));
                write_kappa(json, "kappa_linear", cohen_kappa(counts, KappaWeights::linear));
                write_kappa(json, "kappa_quadratic", cohen_kappa(counts, KappaWeights::quadratic));
            }
            json.end_object();
        }
    json.end_array();
    json.key("majority");
    json.begin_array();
    for (int grade : majority_grades(ratings, num_grades)) json.number(grade);
    json.end_array();
    json.end_object();
    return json.take();
}

std::string repeatability_json(const std::vector<double>& values, const std::vector<int>& subjects,
                               const std::vector<double>& blanks) {
    if (values.size() != subjects.size())
        fail(Status::invalid_argument, "%zu values of %zu subjects; give one subject per value",
             values.size(), subjects.size());
    JsonText json;
    json.begin_object();
    if (!values.empty()) {
        std::map<int, std::vector<double>> captures;
        for (std::size_t i = 0; i < values.size(); ++i) captures[subjects[i]].push_back(values[i]);
        std::vector<std::vector<double>> lists;
        lists.reserve(captures.size());
        for (auto& entry : captures) lists.push_back(std::move(entry.second));
        const Repeatability r = repeatability(lists);
        json.field("within_subject_sd", r.within_subject_sd);
        json.field("sd_low95", r.sd_low95);
        json.field("sd_high95", r.sd_high95);
        json.field("repeatability_coefficient", r.coefficient);
        json.field("degrees_of_freedom", r.degrees);
    }
    if (!blanks.empty()) {
        const DetectionLimit limit = detection_limit(blanks);
        json.field("blank_mean", limit.blank_mean);
        json.field("blank_sd", limit.blank_sd);
        json.field("limit_of_blank", limit.limit_of_blank);
        json.field("limit_of_detection", limit.limit_of_detection);
    }
    json.end_object();
    return json.take();
}

std::string bland_altman_json(const std::vector<double>& first, const std::vector<double>& second) {
    const BlandAltman b = bland_altman(first, second);
    JsonText json;
    json.begin_object();
    json.field("bias", b.bias);
    json.field("sd", b.sd);
    json.field("lower_limit", b.lower_limit);
    json.field("upper_limit", b.upper_limit);
    json.field("bias_low95", b.bias_low95);
    json.field("bias_high95", b.bias_high95);
    json.field("lower_limit_low95", b.lower_low95);
    json.field("lower_limit_high95", b.lower_high95);
    json.field("upper_limit_low95", b.upper_low95);
    json.field("upper_limit_high95", b.upper_high95);
    json.field("slope", b.slope);
    json.field("slope_p_value", b.slope_p_value);
    json.end_object();
    return json.take();
}

std::string score_model_json(const ScoreModel& m) {
    JsonText json;
    json.begin_object();
    json.field("vertices", static_cast<double>(m.mean_face.rows()));
    json.field("samples", static_cast<double>(m.num_samples));
    json.field("components", static_cast<double>(m.num_components()));
    json.field("best_components", m.best_components);
    json.field("one_standard_error_components", m.one_se_components);
    json.field("rmse_cross_validated", m.rmse);
    json.field("q2", m.q2);
    json.field("focus_places", m.focus_places);
    json.field("mean_grade", m.y_mean);
    json.field("lowest", m.lowest);
    json.field("highest", m.highest);
    json.field("curvature_radius_mm", m.curvature_radius_mm);
    write_values(json, "mean_squared_error", m.cv_error);
    write_values(json, "standard_error", m.cv_standard_error);
    write_values(json, "held_out_predictions", m.cv_predictions);
    json.end_object();
    return json.take();
}

}  // namespace mien
