// mien score train|predict|simulate: a biomarker score from faces; mien score
// agreement|repeatability|bland-altman: the statistics of raters and of repeated captures.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "commands.hpp"
#include "confusion.hpp"
#include "plot.hpp"
#include "render.hpp"

namespace mien::cli {
namespace {

struct ScoreCommand {
    Common common;
    std::string data, grades, model, in, out, picture, confusion, zones, zone, stable,
        method = "nipals", values;
    int components = 0, max_components = 10, folds = 10, grade_count = 0;
    bool uniform = false;
    std::string features = "basic";
    double curvature = 0.1, radius = 8.0, target = 0.0;
    std::vector<double> range;
};

const nlohmann::json& list_of(const nlohmann::json& file, const std::string& path,
                              const char* key) {
    if (!file.is_object() || !file.contains(key) || !file[key].is_array())
        throw std::runtime_error(path + ": expected {\"" + key + "\": [...]}");
    return file[key];
}

double number_or_none(const nlohmann::json& value, const std::string& path) {
    if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
    if (!value.is_number())
        throw std::runtime_error(path + ": " + value.dump() + " is neither a number nor null");
    return value.get<double>();
}

/// One grade per face: a number, null, or a list with one grade per rater, which is averaged.
std::vector<double> read_grades(const std::string& path) {
    const nlohmann::json file = read_json(path);
    std::vector<double> grades;
    for (const nlohmann::json& entry : list_of(file, path, "grades")) {
        if (!entry.is_array()) {
            grades.push_back(number_or_none(entry, path));
            continue;
        }
        double sum = 0;
        int given = 0;
        for (const nlohmann::json& grade : entry) {
            const double value = number_or_none(grade, path);
            if (std::isnan(value)) continue;
            sum += value;
            ++given;
        }
        grades.push_back(given > 0 ? sum / given : std::numeric_limits<double>::quiet_NaN());
    }
    return grades;
}

std::vector<std::uint32_t> zone_named(const ScoreCommand& settings, const std::string& name) {
    if (name.empty()) return {};
    if (settings.zones.empty()) throw std::runtime_error("a zone name needs --zones");
    for (auto& [known, vertices] : read_zones(settings.zones))
        if (known == name) return vertices;
    throw std::runtime_error(settings.zones + ": has no zone '" + name + "'");
}

/// Mean grades to whole ones, halves upwards; -1 where there is none.
std::vector<int> whole_grades(const std::vector<double>& grades) {
    std::vector<int> whole;
    whole.reserve(grades.size());
    for (const double grade : grades)
        whole.push_back(std::isnan(grade) ? -1
                                          : std::max(0, static_cast<int>(std::floor(grade + 0.5))));
    return whole;
}

/// Whole grades of the raters against those that the model gave faces held out of its training.
/// Grades are in the file's order, the model's predictions in that of the graded faces.
Confusion confusion_of_training(const std::vector<double>& grades, const nlohmann::json& report) {
    std::vector<double> given, predicted;
    for (const double grade : grades)
        if (!std::isnan(grade)) given.push_back(grade);
    const double lowest = report["lowest"].get<double>(), highest = report["highest"].get<double>();
    for (const nlohmann::json& value : report["held_out_predictions"]) {
        const double score = value.get<double>();  // cut to the range as `score predict` does
        predicted.push_back(highest > lowest ? std::clamp(score, lowest, highest) : score);
    }
    Confusion confusion;
    confusion.counts = confusion_counts(whole_grades(given), whole_grades(predicted), 0);
    confusion.title = "Faces held out";
    confusion.row_label = "raters' grade";
    confusion.column_label = "model's grade";
    return confusion;
}

/// The cross-validated error over the number of components, and the latent variables on the
/// template.
void draw_training(const std::string& path, const Session& session, const ScoreModel& model,
                   const nlohmann::json& report) {
    Curve curve;
    curve.label = "mean square error";
    curve.markers = true;
    for (std::size_t k = 0; k < report["mean_squared_error"].size(); ++k) {
        curve.x.push_back(static_cast<double>(k));
        curve.y.push_back(report["mean_squared_error"][k]);
        curve.error.push_back(report["standard_error"][k]);
    }
    PlotOptions plot;
    plot.title = "Cross-validated error";
    plot.x_label = "components";
    plot.y_label = "square error";
    plot.zero_y = true;
    std::vector<Image> rows{draw_plot({curve}, plot)};
    const MeshArrays face =
        arrays_of(model.simulate(session, nullptr, report["mean_grade"].get<double>()));
    for (int component = -1; component < std::min(3, report["components"].get<int>());
         ++component) {
        RenderOptions options;
        options.size = 320;
        options.scalar = model.latent(component);
        options.low = 0;
        options.label = component < 0 ? "mm per grade" : "mm at one deviation";
        options.title =
            component < 0 ? "Along the score" : "Latent variable " + std::to_string(component + 1);
        rows.push_back(render_mesh(face, options));
    }
    write_png(path, stack_images(rows, false));
}

void run_train(const ScoreCommand& settings) {
    const Session session(settings.common.num_threads);
    ScoreSettings options;
    options.c.method = settings.method == "simpls" ? MIEN_PLS_SIMPLS : MIEN_PLS_NIPALS;
    options.c.num_components = settings.components;
    options.c.max_components = settings.max_components;
    options.c.folds = settings.folds;
    options.c.seed = settings.common.seed + 1;
    options.c.focus = settings.uniform ? 0 : 1;
    options.c.curvature_share = settings.curvature;
    options.c.curvature_radius_mm = settings.radius;
    options.c.features = settings.features == "all"
                             ? MIEN_SCORE_FEATURES_ALL
                             : MIEN_SCORE_FEATURES_DISPLACEMENT_AND_CURVATURE;
    if (settings.range.size() == 2) {
        options.c.lowest = settings.range[0];
        options.c.highest = settings.range[1];
    }
    options.zone = zone_named(settings, settings.zone);
    options.stable_zone = zone_named(settings, settings.stable);
    options.progress = progress_bar();
    const std::vector<double> grades = read_grades(settings.grades);
    const ScoreModel model = ScoreModel::train(session, settings.data, grades, options);
    model.save(session, settings.out);
    nlohmann::json report = nlohmann::json::parse(model.json());
    std::printf("%d faces, %d components (least error: %d); held-out faces: error %.3f, R2 %.3f\n",
                report["samples"].get<int>(), report["components"].get<int>(),
                report["best_components"].get<int>(), report["rmse_cross_validated"].get<double>(),
                report["q2"].get<double>());
    if (!settings.picture.empty()) draw_training(settings.picture, session, model, report);
    const Confusion confusion = confusion_of_training(grades, report);
    if (!settings.confusion.empty()) write_png(settings.confusion, draw_confusion(confusion));
    report["confusion"] = confusion.counts;
    report["model"] = settings.out;
    write_report(settings.common, report);
}

void run_predict(const ScoreCommand& settings) {
    const Session session(settings.common.num_threads);
    const ScoreModel model(session, settings.model);
    const mien_score_prediction p = model.predict(session, Mesh(session, settings.in));
    std::printf("score %.3f, 95 %% between %.3f and %.3f%s\n", p.score, p.low95, p.high95,
                p.extrapolates ? "; this face is unlike the training faces" : "");
    write_report(settings.common, {{"in", settings.in},
                                   {"score", p.score},
                                   {"low95", p.low95},
                                   {"high95", p.high95},
                                   {"leverage", p.leverage},
                                   {"extrapolates", p.extrapolates != 0}});
}

void run_simulate(const ScoreCommand& settings) {
    const Session session(settings.common.num_threads);
    const ScoreModel model(session, settings.model);
    std::unique_ptr<Mesh> face;
    if (!settings.in.empty()) face = std::make_unique<Mesh>(session, settings.in);
    const Mesh result = model.simulate(session, face.get(), settings.target);
    result.save(session, settings.out);
    if (!settings.picture.empty()) {
        const double mean = nlohmann::json::parse(model.json())["mean_grade"].get<double>();
        const MeshArrays before = arrays_of(face ? *face : model.simulate(session, nullptr, mean));
        const MeshArrays after = arrays_of(result);
        RenderOptions options;
        options.size = 360;
        options.framing = &before;
        options.title = "before";
        std::vector<Image> rows{render_mesh(before, options)};
        options.title = "score " + short_number(settings.target);
        for (std::size_t v = 0; v < after.positions.size(); ++v) {
            double square = 0;
            for (std::size_t k = 0; k < 3; ++k)
                square += std::pow(after.positions[v][k] - before.positions[v][k], 2);
            options.scalar.push_back(std::sqrt(square));
        }
        options.label = "moved, mm";
        rows.push_back(render_mesh(after, options));
        write_png(settings.picture, stack_images(rows, false));
    }
    write_report(settings.common,
                 {{"in", settings.in}, {"target", settings.target}, {"out", settings.out}});
}

/// A matrix for each pair of raters.
void draw_agreement(const std::string& path, const nlohmann::json& report) {
    std::vector<Confusion> matrices;
    for (const nlohmann::json& pair : report["pairs"]) {
        Confusion one;
        one.counts = pair["confusion"].get<std::vector<std::vector<double>>>();
        one.row_label = "rater " + std::to_string(pair["raters"][0].get<int>() + 1);
        one.column_label = "rater " + std::to_string(pair["raters"][1].get<int>() + 1);
        one.title = "agree " +
                    short_number(std::round(1000 * pair["percent_agreement"].get<double>()) / 10) +
                    " %";
        matrices.push_back(std::move(one));
    }
    write_png(path, draw_confusions(matrices));
}

void run_agreement(const ScoreCommand& settings) {
    const nlohmann::json file = read_json(settings.grades);
    std::vector<std::int32_t> ratings;
    std::size_t raters = 0;
    int highest = 0;
    for (const nlohmann::json& row : list_of(file, settings.grades, "grades")) {
        if (!row.is_array() || (raters != 0 && row.size() != raters))
            throw std::runtime_error(settings.grades +
                                     ": every entry must be a list with one grade per rater");
        raters = row.size();
        for (const nlohmann::json& grade : row) {
            if (!grade.is_null() && !grade.is_number_integer())
                throw std::runtime_error(settings.grades + ": " + grade.dump() +
                                         " is not a whole grade or null");
            ratings.push_back(grade.is_null() ? -1 : grade.get<std::int32_t>());
            highest = std::max(highest, ratings.back());
        }
    }
    const Session session(settings.common.num_threads);
    const int grades = settings.grade_count > 0 ? settings.grade_count : highest + 1;
    const nlohmann::json report = nlohmann::json::parse(
        rater_agreement(session, ratings, static_cast<std::uint32_t>(raters), grades));
    std::printf("all agree %.1f %%, within one grade %.1f %%, Fleiss' kappa %s\n",
                100 * report["percent_agreement_all"].get<double>(),
                100 * report["percent_within_one_grade"].get<double>(),
                report["fleiss"]["kappa"].dump().c_str());
    for (const nlohmann::json& pair : report["pairs"])
        std::printf("raters %d and %d: agree %.1f %%, quadratic kappa %s\n",
                    pair["raters"][0].get<int>() + 1, pair["raters"][1].get<int>() + 1,
                    100 * pair["percent_agreement"].get<double>(),
                    pair.contains("kappa_quadratic")
                        ? pair["kappa_quadratic"]["kappa"].dump().c_str()
                        : "none");
    if (!settings.picture.empty()) draw_agreement(settings.picture, report);
    write_report(settings.common, report);
}

void run_repeatability(const ScoreCommand& settings) {
    const nlohmann::json file = read_json(settings.values);
    std::vector<double> values, blanks;
    std::vector<std::int32_t> subjects;
    std::int32_t subject = 0;
    if (file.contains("captures"))
        for (const nlohmann::json& row : list_of(file, settings.values, "captures")) {
            for (const nlohmann::json& value : row) {
                values.push_back(number_or_none(value, settings.values));
                subjects.push_back(subject);
            }
            ++subject;
        }
    if (file.contains("blanks"))
        for (const nlohmann::json& value : list_of(file, settings.values, "blanks"))
            blanks.push_back(number_or_none(value, settings.values));
    if (values.empty() && blanks.empty())
        throw std::runtime_error(settings.values +
                                 ": expected {\"captures\": [[...], ...], \"blanks\": [...]}");
    const Session session(settings.common.num_threads);
    const nlohmann::json report =
        nlohmann::json::parse(repeatability(session, values, subjects, blanks));
    for (const auto& [name, value] : report.items())
        std::printf("%-26s %s\n", name.c_str(), value.dump().c_str());
    write_report(settings.common, report);
}

void run_bland_altman(const ScoreCommand& settings) {
    const nlohmann::json file = read_json(settings.values);
    std::vector<double> first, second;
    for (const nlohmann::json& value : list_of(file, settings.values, "first"))
        first.push_back(number_or_none(value, settings.values));
    for (const nlohmann::json& value : list_of(file, settings.values, "second"))
        second.push_back(number_or_none(value, settings.values));
    if (first.size() != second.size())
        throw std::runtime_error(settings.values + ": " + std::to_string(first.size()) +
                                 " first and " + std::to_string(second.size()) +
                                 " second values; give one of each per subject");
    const Session session(settings.common.num_threads);
    const nlohmann::json report = nlohmann::json::parse(bland_altman(session, first, second));
    for (const auto& [name, value] : report.items())
        std::printf("%-26s %s\n", name.c_str(), value.dump().c_str());
    if (!settings.picture.empty()) {
        Curve points, bias, lower, upper;
        points.label = "subjects";
        points.markers = true;
        for (std::size_t k = 0; k < first.size(); ++k) {
            points.x.push_back(0.5 * (first[k] + second[k]));
            points.y.push_back(first[k] - second[k]);
        }
        points.line = false;
        const auto [low, high] = std::minmax_element(points.x.begin(), points.x.end());
        bias.label = "bias";
        lower.label = "95 % limits";
        for (auto [curve, key] : {std::pair<Curve*, const char*>{&bias, "bias"},
                                  {&lower, "lower_limit"},
                                  {&upper, "upper_limit"}}) {
            curve->x = {*low, *high};
            curve->y = {report[key], report[key]};
        }
        PlotOptions plot;
        plot.title = "Bland-Altman";
        plot.x_label = "mean of both";
        plot.y_label = "first - second";
        write_png(settings.picture, draw_plot({points, bias, lower, upper}, plot));
    }
    write_report(settings.common, report);
}

using Settings = std::shared_ptr<ScoreCommand>;

void add_score_training(CLI::App* score, const Settings& settings) {
    CLI::App* train = score->add_subcommand("train", "learn a score from graded faces");
    train->add_option("--data", settings->data, "dataset of faces in correspondence")->required();
    train
        ->add_option("--grades", settings->grades,
                     "{\"grades\": [...]}, per face a number, null, or one per rater")
        ->required();
    train->add_option("--zones", settings->zones, "zone file");
    train->add_option("--zone", settings->zone, "zone of interest; default: the whole face");
    train->add_option("--stable", settings->stable,
                      "zone that faces are aligned on; default: the whole face");
    train->add_option("--method", settings->method)
        ->check(CLI::IsMember({"nipals", "simpls"}))
        ->capture_default_str();
    train->add_option("--components", settings->components, "0: by cross-validation")
        ->capture_default_str();
    train->add_option("--max-components", settings->max_components)->capture_default_str();
    train->add_option("--folds", settings->folds, "over subjects; 0: leave one out")
        ->capture_default_str();
    train->add_flag("--uniform", settings->uniform,
                    "every vertex counts by its area, not by how far it moves with the score");
    train->add_option("--curvature", settings->curvature, "weight of curvature features; 0: none")
        ->capture_default_str();
    train
        ->add_option("--features", settings->features,
                     "of each vertex: displacement and principal curvatures (5), or all 17")
        ->check(CLI::IsMember({"basic", "all"}))
        ->capture_default_str();
    train->add_option("--curvature-radius", settings->radius, "mm")->capture_default_str();
    train->add_option("--range", settings->range, "lowest and highest grade")->expected(2);
    train->add_option("--out", settings->out, "score model")->required();
    train->add_option("--picture", settings->picture,
                      "PNG: error by components, latent variables on the face");
    train->add_option("--confusion", settings->confusion,
                      "PNG: raters' whole grades against the model's, of faces held out");
    add_common_options(*train, settings->common, true);
    train->footer(
        "Example: mien score train --data faces.safetensors --grades grades.json --range 0 4 --out "
        "sag.safetensors");
    train->callback([settings] { run_train(*settings); });
}

void add_use_of_scores(CLI::App* score, const Settings& settings) {
    CLI::App* predict = score->add_subcommand("predict", "the score of a fitted face");
    predict->add_option("--model", settings->model, "score model")->required();
    predict->add_option("--in", settings->in, "fitted face")->required();
    add_common_options(*predict, settings->common);
    predict->footer("Example: mien score predict --model sag.safetensors --in fitted.ply");
    predict->callback([settings] { run_predict(*settings); });

    CLI::App* simulate =
        score->add_subcommand("simulate", "a face as it would look with another score");
    simulate->add_option("--model", settings->model, "score model")->required();
    simulate->add_option("--in", settings->in, "fitted face; default: the mean face");
    simulate->add_option("--target", settings->target, "the score wanted")->required();
    simulate->add_option("--out", settings->out, "mesh")->required();
    simulate->add_option("--picture", settings->picture, "PNG: before and after");
    add_common_options(*simulate, settings->common);
    simulate->footer(
        "Example: mien score simulate --model sag.safetensors --in fitted.ply --target 4 --out "
        "older.ply");
    simulate->callback([settings] { run_simulate(*settings); });
}

void add_statistics(CLI::App* score, const Settings& settings) {
    CLI::App* agreement = score->add_subcommand("agreement", "how far raters agree");
    agreement
        ->add_option("--grades", settings->grades,
                     "{\"grades\": [[rater 1, rater 2, ...], ...]}, null: missing")
        ->required();
    agreement->add_option("--grade-count", settings->grade_count, "default: the highest grade + 1");
    agreement->add_option("--picture", settings->picture,
                          "PNG: the confusion matrix of each pair of raters");
    add_common_options(*agreement, settings->common);
    agreement->footer(
        "Example: mien score agreement --grades grades.json --json agreement.json --picture "
        "pairs.png");
    agreement->callback([settings] { run_agreement(*settings); });

    CLI::App* repeat =
        score->add_subcommand("repeatability", "repeatability coefficient and limit of detection");
    repeat
        ->add_option("--values", settings->values,
                     "{\"captures\": [[...], ...], \"blanks\": [...]}")
        ->required();
    add_common_options(*repeat, settings->common);
    repeat->footer("Example: mien score repeatability --values volumes.json");
    repeat->callback([settings] { run_repeatability(*settings); });

    CLI::App* compare =
        score->add_subcommand("bland-altman", "two methods, or two captures, on the same subjects");
    compare
        ->add_option("--values", settings->values,
                     "{\"first\": [...], \"second\": [...]}, one of each per subject")
        ->required();
    compare->add_option("--picture", settings->picture,
                        "PNG: differences over means, with the limits of agreement");
    add_common_options(*compare, settings->common);
    compare->footer(
        "Example: mien score bland-altman --values volumes.json --picture agreement.png");
    compare->callback([settings] { run_bland_altman(*settings); });
}

}  // namespace

void add_score_commands(CLI::App& app) {
    CLI::App* score =
        app.add_subcommand("score", "biomarker scores, rater agreement, repeatability");
    score->require_subcommand(1);
    const auto settings = std::make_shared<ScoreCommand>();
    add_score_training(score, settings);
    add_use_of_scores(score, settings);
    add_statistics(score, settings);
}

}  // namespace mien::cli
