// mien train, mien neutralize, mien evaluate neutralization: expressions off a face.
#include <algorithm>
#include <cstdio>

#include "commands.hpp"
#include "plot.hpp"

namespace mien::cli {
namespace {

const std::vector<std::pair<std::string, int>> kFits = {{"mixture", MIEN_FIT_MIXTURE},
                                                        {"map", MIEN_FIT_MAP},
                                                        {"exact", MIEN_FIT_EXACT},
                                                        {"alternating", MIEN_FIT_ALTERNATING}};
const std::vector<std::pair<std::string, int>> kPoses = {
    {"auto", MIEN_POSE_AUTO}, {"keep", MIEN_POSE_KEEP}, {"rigid", MIEN_POSE_RIGID}};

int number_of(const std::vector<std::pair<std::string, int>>& names, const std::string& name) {
    for (const auto& [known, number] : names)
        if (known == name) return number;
    throw std::runtime_error("unknown name '" + name + "'");
}

CLI::IsMember one_of(const std::vector<std::pair<std::string, int>>& names) {
    std::vector<std::string> known;
    for (const auto& entry : names) known.push_back(entry.first);
    return CLI::IsMember(known);
}

/// Vertices of some zones of a zone file, together; `names` are separated by commas.
std::vector<std::uint32_t> zone_vertices(const std::string& path, const std::string& names) {
    std::vector<std::uint32_t> vertices;
    if (names.empty()) return vertices;
    if (path.empty()) throw std::runtime_error("zone names need a zone file: give --zones");
    const auto zones = read_zones(path);
    for (std::size_t begin = 0; begin <= names.size();) {
        const std::size_t end = std::min(names.find(',', begin), names.size());
        const std::string name = names.substr(begin, end - begin);
        const auto zone = std::find_if(zones.begin(), zones.end(),
                                       [&](const auto& entry) { return entry.first == name; });
        if (zone == zones.end()) throw std::runtime_error(path + ": has no zone '" + name + "'");
        vertices.insert(vertices.end(), zone->second.begin(), zone->second.end());
        begin = end + 1;
    }
    return vertices;
}

/// A zone file is made for the whole template; a model may cover its first vertices only.
void keep_below(std::vector<std::uint32_t>& vertices, std::uint64_t count) {
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(),
                                  [count](std::uint32_t vertex) { return vertex >= count; }),
                   vertices.end());
}

struct TrainSettings {
    Common common;
    std::string data, out, method = "jpca", lambda = "auto", zones, stable;
    std::string part, shard_out;
    std::vector<std::string> merge;
    int identity_modes = 50, expression_modes = 50, shard_rank = 512;
};

/// "K/N", K from 1 to N.
std::pair<int, int> part_of(const std::string& text) {
    int part = 0, count = 0, used = 0;
    if (std::sscanf(text.c_str(), "%d/%d%n", &part, &count, &used) != 2 ||
        used != static_cast<int>(text.size()) || part < 1 || part > count)
        throw std::runtime_error("--part takes K/N with K from 1 to N, not '" + text + "'");
    return {part - 1, count};
}

void run_shard(const TrainSettings& settings) {
    if (settings.shard_out.empty()) throw CLI::RequiredError("--shard-out");
    const auto [part, count] = part_of(settings.part);
    const Session session(settings.common.num_threads);
    ExpressionModel::write_shard(session, settings.data, part, count, settings.shard_out,
                                 settings.shard_rank, progress_bar());
    std::printf("%s: part %d of %d\n", settings.shard_out.c_str(), part + 1, count);
    write_report(settings.common,
                 {{"data", settings.data}, {"shard", settings.shard_out}, {"part", part + 1}, {"parts", count}});
}

void run_train(const TrainSettings& settings) {
    if (settings.data.empty() == settings.merge.empty())
        throw CLI::RequiredError("either --data or --merge");
    if (!settings.part.empty()) return run_shard(settings);
    if (settings.out.empty()) throw CLI::RequiredError("--out");
    const Session session(settings.common.num_threads);
    TrainOptions options;
    options.method = settings.method == "qojpca" ? MIEN_TRAIN_QOJPCA : MIEN_TRAIN_JPCA;
    options.identity_modes = settings.identity_modes;
    options.expression_modes = settings.expression_modes;
    if (settings.lambda != "auto") {
        std::size_t used = 0;
        try {
            options.lambda = std::stod(settings.lambda, &used);
        } catch (const std::exception&) {
            used = 0;
        }
        if (used != settings.lambda.size() || !(options.lambda > 0))
            throw std::runtime_error("--lambda takes 'auto' or a positive number, not '" +
                                     settings.lambda + "'");
    }
    const std::vector<std::uint32_t> stable = zone_vertices(settings.zones, settings.stable);
    options.stable_vertices = stable.data();
    options.stable_count = stable.size();
    const ExpressionModel model =
        settings.merge.empty()
            ? ExpressionModel::train(session, settings.data, options, progress_bar())
            : ExpressionModel::merge(session, settings.merge, options, progress_bar());
    model.save(session, settings.out);
    nlohmann::json report = nlohmann::json::parse(model.json());
    std::printf("%s: %d subjects, %d faces, %u identity and %u expression modes\n",
                settings.out.c_str(), report["subjects"].get<int>(), report["faces"].get<int>(),
                model.identity_modes(), model.expression_modes());
    if (report["skipped_faces"].get<int>() != 0)
        std::printf("%d faces left out: their subjects have no neutral face\n",
                    report["skipped_faces"].get<int>());
    if (settings.method == "qojpca")
        std::printf("lambda %.4g, %d iterations%s\n", report["lambda"].get<double>(),
                    report["iterations"].get<int>(),
                    report["converged"].get<bool>() ? "" : " (not converged)");
    if (settings.merge.empty())
        report["data"] = settings.data;
    else
        report["shards"] = settings.merge;
    report["model"] = settings.out;
    write_report(settings.common, report);
}

struct NeutralizeSettings {
    Common common;
    std::string model, in, out, fit = "mixture", pose = "auto", scan, scan_out, uncertainty_out, identity_out, weights;
    std::vector<std::string> with;
    int sweeps = 200;
    double max_distance = 0;
};

/// {"weight": [...]} as `mien register --json` writes it, or a plain list: one weight per vertex.
std::vector<double> read_weights(const std::string& path) {
    const nlohmann::json file = read_json(path);
    const nlohmann::json& list = file.is_object() && file.contains("weight") ? file["weight"] : file;
    if (!list.is_array()) throw std::runtime_error(path + ": expected [w, ...] or {\"weight\": [w, ...]}");
    std::vector<double> weights;
    for (const nlohmann::json& value : list) {
        if (!value.is_number()) throw std::runtime_error(path + ": " + value.dump() + " is not a weight");
        weights.push_back(value.get<double>());
    }
    return weights;
}

/// Several scans of one person: the neutral face of the first, and the shared one.
void run_series(const NeutralizeSettings& settings) {
    if (!settings.scan.empty() || !settings.uncertainty_out.empty())
        throw std::runtime_error("--scan and --uncertainty-out do not go with --with");
    const Session session(settings.common.num_threads);
    const ExpressionModel model(session, settings.model);
    std::vector<Mesh> faces{Mesh(session, settings.in)};
    for (const std::string& path : settings.with) faces.emplace_back(session, path);
    SeriesOptions options;
    options.method = number_of(kFits, settings.fit);
    options.pose = number_of(kPoses, settings.pose);
    const Series series(session, model, faces, options, progress_bar());
    series.neutral(0).save(session, settings.out);
    if (!settings.identity_out.empty()) series.identity().save(session, settings.identity_out);
    std::printf("%zu faces of one person\n", faces.size());
    write_report(settings.common, {{"in", settings.in}, {"with", settings.with}, {"out", settings.out}});
}

void run_neutralize(const NeutralizeSettings& settings) {
    if (!settings.with.empty()) return run_series(settings);
    if (settings.scan.empty() != settings.scan_out.empty())
        throw CLI::RequiredError("--scan and --scan-out together");
    const Session session(settings.common.num_threads);
    const ExpressionModel model(session, settings.model);
    const Mesh face(session, settings.in);
    NeutralizeOptions options;
    options.method = number_of(kFits, settings.fit);
    options.pose = number_of(kPoses, settings.pose);
    options.max_sweeps = settings.sweeps;
    const bool has_prior = options.method == MIEN_FIT_MIXTURE || options.method == MIEN_FIT_MAP;
    options.uncertainty = has_prior;
    std::vector<double> weights;
    if (!settings.weights.empty()) {
        weights = read_weights(settings.weights);
        options.set_weights(weights);
    }
    const Neutralization result(session, model, face, options, progress_bar());
    result.mesh().save(session, settings.out);
    nlohmann::json report = nlohmann::json::parse(result.json());
    if (report.contains("expression"))
        std::printf("expression: %s\n", report["expression"].get<std::string>().c_str());
    std::printf("moved %.3f mm on average, %.3f mm at most\n",
                report["mean_displacement_mm"].get<double>(),
                report["max_displacement_mm"].get<double>());
    for (const nlohmann::json& warning : report["warnings"])
        std::printf("note: %s\n", warning.get<std::string>().c_str());
    if (!settings.uncertainty_out.empty()) {
        std::string text;
        char line[32];
        for (double value : result.uncertainty()) {
            std::snprintf(line, sizeof line, "%.9g\n", value);
            text += line;
        }
        write_file(settings.uncertainty_out, text);
    }
    if (!settings.scan.empty()) {
        const Mesh scan(session, settings.scan);
        result.apply_to_scan(session, scan, settings.max_distance).save(session, settings.scan_out);
        report["scan_out"] = settings.scan_out;
    }
    report["in"] = settings.in;
    report["out"] = settings.out;
    write_report(settings.common, report);
}

struct EvaluateSettings {
    Common common;
    std::string model, data, against, fit = "mixture", against_fit = "alternating", zones, zone, stable,
        picture;
    int sweeps = 200, against_sweeps = 3;
};

void print_row(const nlohmann::json& row, bool compared) {
    auto number = [](const nlohmann::json& value) {
        return value.is_number() ? value.get<double>() : std::nan("");
    };
    std::printf("%-16.16s %5.2f (%4.2f) %5.2f (%4.2f)", row["expression"].get<std::string>().c_str(),
                row["baseline"]["mean_mm"].get<double>(), row["baseline"]["sd_mm"].get<double>(),
                row["result"]["mean_mm"].get<double>(), row["result"]["sd_mm"].get<double>());
    if (compared)
        std::printf(" %5.2f (%4.2f)", row["against"]["mean_mm"].get<double>(),
                    row["against"]["sd_mm"].get<double>());
    const nlohmann::json& effect = row[compared ? "effect_over_against" : "effect_over_baseline"];
    std::printf(" %7.2f %6.1f\n", number(effect["cohens_d"]), 100 * number(effect["superiority"]));
}

void draw_table(const std::string& path, const nlohmann::json& report, bool compared) {
    std::vector<std::string> names, series{"untouched"};
    if (compared) series.push_back("against");
    series.push_back("result");
    std::vector<std::vector<double>> values(series.size());
    for (const nlohmann::json& row : report["expressions"]) {
        names.push_back(row["expression"]);
        values[0].push_back(row["baseline"]["mean_mm"]);
        if (compared) values[1].push_back(row["against"]["mean_mm"]);
        values.back().push_back(row["result"]["mean_mm"]);
    }
    PlotOptions options;
    options.title = "Distance to the true neutral face";
    options.y_label = "mm";
    options.zero_y = true;
    options.width = std::max(640, 56 * static_cast<int>(names.size()));
    write_png(path, draw_bars(names, series, values, options));
}

void run_evaluate(const EvaluateSettings& settings) {
    const Session session(settings.common.num_threads);
    const ExpressionModel model(session, settings.model);
    EvaluateOptions options;
    options.method = number_of(kFits, settings.fit);
    options.max_sweeps = settings.sweeps;
    options.against_method = number_of(kFits, settings.against_fit);
    options.against_max_sweeps = settings.against_sweeps;
    std::vector<std::uint32_t> zone = zone_vertices(settings.zones, settings.zone);
    std::vector<std::uint32_t> stable = zone_vertices(settings.zones, settings.stable);
    keep_below(zone, model.vertex_count());
    keep_below(stable, model.vertex_count());
    options.zone_vertices = zone.data();
    options.zone_count = zone.size();
    options.stable_vertices = stable.data();
    options.stable_count = stable.size();
    const bool compared = !settings.against.empty();
    const ExpressionModel against = compared ? ExpressionModel(session, settings.against) : model;
    if (compared) options.against = against.get();
    nlohmann::json report =
        nlohmann::json::parse(model.evaluate(session, settings.data, options, progress_bar()));
    std::printf("%-16s %12s %12s", "mm (sd)", "untouched", settings.fit.c_str());
    if (compared) std::printf(" %12s", "against");
    std::printf(" %7s %6s\n", "d", "> %");
    for (const nlohmann::json& row : report["expressions"]) print_row(row, compared);
    print_row(report["all"], compared);
    if (!settings.picture.empty()) draw_table(settings.picture, report, compared);
    report["model"] = settings.model;
    report["data"] = settings.data;
    report["fit"] = settings.fit;
    if (compared) report["against"] = settings.against;
    write_report(settings.common, report);
}

void add_train(CLI::App& app) {
    auto settings = std::make_shared<TrainSettings>();
    CLI::App* train = app.add_subcommand("train", "learn an expression model from a study's faces");
    train->add_option("--data", settings->data, "dataset (safetensors)")->check(CLI::ExistingFile);
    train->add_option("--merge", settings->merge, "train from shards instead")->check(CLI::ExistingFile);
    train->add_option("--part", settings->part, "K/N: write the shard of part K of the data only");
    train->add_option("--shard-out", settings->shard_out, "with --part: the shard file");
    train->add_option("--shard-rank", settings->shard_rank, "directions that a shard keeps")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    train->add_option("--method", settings->method, "how the subspaces are found")
        ->check(CLI::IsMember({"jpca", "qojpca"}))
        ->capture_default_str();
    train->add_option("--identity-modes", settings->identity_modes)
        ->check(CLI::Range(1, 4000))
        ->capture_default_str();
    train->add_option("--expression-modes", settings->expression_modes)
        ->check(CLI::Range(1, 4000))
        ->capture_default_str();
    train->add_option("--lambda", settings->lambda, "qojpca: weight of orthogonality, or auto")
        ->capture_default_str();
    train->add_option("--zones", settings->zones, "zone file, for --stable")->check(CLI::ExistingFile);
    train->add_option("--stable", settings->stable,
                      "zones (comma between) that every face is aligned on, for faces with posture");
    train->add_option("--out", settings->out, "model file");
    add_common_options(*train, settings->common);
    train->footer("Example: mien train --data faces.safetensors --method jpca --out expr.safetensors");
    train->callback([settings] { run_train(*settings); });
}

void add_neutralize(CLI::App& app) {
    auto settings = std::make_shared<NeutralizeSettings>();
    CLI::App* neutralize = app.add_subcommand("neutralize", "take the expression off a fitted face");
    neutralize->add_option("--model", settings->model, "expression model")
        ->required()
        ->check(CLI::ExistingFile);
    neutralize->add_option("--in", settings->in, "face in the model's topology")
        ->required()
        ->check(CLI::ExistingFile);
    neutralize->add_option("--out", settings->out, "neutral face")->required();
    neutralize->add_option("--fit", settings->fit, "how the face is taken apart")
        ->check(one_of(kFits))
        ->capture_default_str();
    neutralize->add_option("--sweeps", settings->sweeps, "alternating: at most so many")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    neutralize->add_option("--pose", settings->pose, "where the face lies against the training faces")
        ->check(one_of(kPoses))
        ->capture_default_str();
    neutralize->add_option("--weights", settings->weights,
                           "registration report (mien register --json) or a list: how much each vertex counts")
        ->check(CLI::ExistingFile);
    neutralize->add_option("--scan", settings->scan, "the scan that the face was fitted to")
        ->check(CLI::ExistingFile);
    neutralize->add_option("--scan-out", settings->scan_out, "the scan, neutralized");
    neutralize->add_option("--max-distance", settings->max_distance,
                           "scan vertices farther from the face move with their neighbourhood, mm");
    neutralize->add_option("--with", settings->with, "more faces of the same person: one identity for all")
        ->check(CLI::ExistingFile);
    neutralize->add_option("--identity-out", settings->identity_out,
                           "with --with: the person's shared neutral face");
    neutralize->add_option("--uncertainty-out", settings->uncertainty_out,
                           "one deviation per vertex and line, mm");
    add_common_options(*neutralize, settings->common);
    neutralize->footer(
        "Example: mien neutralize --model expr.safetensors --in fitted.ply --out neutral.ply");
    neutralize->callback([settings] { run_neutralize(*settings); });
}

void add_evaluate(CLI::App& app) {
    auto settings = std::make_shared<EvaluateSettings>();
    CLI::App* group = app.add_subcommand("evaluate", "errors against known truth");
    group->require_subcommand(1);
    CLI::App* evaluate = group->add_subcommand("neutralization", "errors of neutralization over a dataset");
    evaluate->add_option("--model", settings->model, "expression model")
        ->required()
        ->check(CLI::ExistingFile);
    evaluate->add_option("--data", settings->data, "dataset (safetensors)")
        ->required()
        ->check(CLI::ExistingFile);
    evaluate->add_option("--fit", settings->fit)->check(one_of(kFits))->capture_default_str();
    evaluate->add_option("--sweeps", settings->sweeps, "alternating: at most so many")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    evaluate->add_option("--against", settings->against, "second model to compare with")
        ->check(CLI::ExistingFile);
    evaluate->add_option("--against-fit", settings->against_fit)
        ->check(one_of(kFits))
        ->capture_default_str();
    evaluate->add_option("--against-sweeps", settings->against_sweeps)
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    evaluate->add_option("--zones", settings->zones, "zone file")->check(CLI::ExistingFile);
    evaluate->add_option("--zone", settings->zone, "measure on these zones only");
    evaluate->add_option("--stable", settings->stable, "align every face on these zones first");
    evaluate->add_option("--picture", settings->picture, "PNG of the table");
    add_common_options(*evaluate, settings->common);
    evaluate->footer(
        "Example: mien evaluate neutralization --model expr.safetensors --data test.safetensors");
    evaluate->callback([settings] { run_evaluate(*settings); });
}

}  // namespace

void add_expression_commands(CLI::App& app) {
    add_train(app);
    add_neutralize(app);
    add_evaluate(app);
}

}  // namespace mien::cli
