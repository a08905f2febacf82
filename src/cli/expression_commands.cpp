// mien neutralize, mien evaluate neutralization: expressions off a face.
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
    known.reserve(names.size());
    for (const auto& entry : names) known.push_back(entry.first);
    return CLI::IsMember(known);
}

struct NeutralizeSettings {
    Common common;
    std::string model, in, out, fit = "mixture", pose = "auto", scan, scan_out, uncertainty_out,
                                identity_out, weights;
    std::string zones, changing, treated;
    double margin = NeutralizeOptions().treated_margin_mm;
    std::vector<std::string> with, with_weights, with_out;
    int sweeps = 200;
    double max_distance = 0;
};

/// Several scans of one person: a neutral face of each, and the shared one.
void run_series(const NeutralizeSettings& settings) {
    if (!settings.scan.empty() || !settings.uncertainty_out.empty() || !settings.treated.empty())
        throw std::runtime_error(
            "--scan, --uncertainty-out and --treated do not go with --with (there: --changing)");
    const Session session(settings.common.num_threads);
    const ExpressionModel model(session, settings.model);
    std::vector<Mesh> faces{Mesh(session, settings.in)};
    for (const std::string& path : settings.with) faces.emplace_back(session, path);
    SeriesOptions options;
    options.method = number_of(kFits, settings.fit);
    options.pose = number_of(kPoses, settings.pose);
    const std::vector<std::uint32_t> changing = zone_vertices(settings.zones, settings.changing);
    options.changing_vertices = changing.data();
    options.changing_count = changing.size();
    std::vector<double> weights;
    if (!settings.weights.empty() || !settings.with_weights.empty()) {
        if (settings.weights.empty() || settings.with_weights.size() != settings.with.size())
            throw std::runtime_error(
                "in a series every face has weights or none: give --weights, and --with-weights "
                "for each face of --with");
        weights = read_weights(settings.weights, "weight");
        for (const std::string& path : settings.with_weights) {
            const std::vector<double> more = read_weights(path, "weight");
            weights.insert(weights.end(), more.begin(), more.end());
        }
        options.set_weights(weights);
    }
    const Series series(session, model, faces, options, progress_bar());
    series.neutral(0).save(session, settings.out);
    for (std::size_t k = 0; k < settings.with_out.size(); ++k)
        series.neutral(static_cast<std::int32_t>(k + 1)).save(session, settings.with_out[k]);
    if (!settings.identity_out.empty()) series.identity().save(session, settings.identity_out);
    nlohmann::json report = nlohmann::json::parse(series.json());
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const nlohmann::json& face = report["faces"][k];
        const std::string& path = k == 0 ? settings.in : settings.with[k - 1];
        std::printf("%s: %s, %.3f mm from the shared face\n", path.c_str(),
                    face.value("expression", "fitted").c_str(),
                    face["distance_to_shared_mm"].get<double>());
        for (const nlohmann::json& warning : face["warnings"])
            std::printf("note: %s: %s\n", path.c_str(), warning.get<std::string>().c_str());
    }
    report["in"] = settings.in;
    report["with"] = settings.with;
    report["out"] = settings.out;
    write_report(settings.common, report);
}

/// What is taken off inside a treated zone, read as a treatment and as an expression.
void print_readings(const nlohmann::json& zone) {
    for (const char* key : {"treated", "as_expression"}) {
        const nlohmann::json& reading = zone[key];
        std::printf("treated zone, %s: %.3f mL (%.3f mm) taken off, expression %s (%.0f %%)\n",
                    std::string(key) == "treated" ? "no witness" : "as a witness",
                    reading["removed_ml"].get<double>(), reading["removed_mm"].get<double>(),
                    reading["expression"].get<std::string>().c_str(),
                    100 * reading["probability"].get<double>());
    }
}

void run_neutralize(const NeutralizeSettings& settings) {
    if (settings.with_out.size() > settings.with.size())
        throw std::runtime_error("--with-out names more files than --with has faces");
    if (!settings.with.empty()) return run_series(settings);
    if (!settings.changing.empty() || !settings.with_weights.empty() ||
        !settings.identity_out.empty())
        throw std::runtime_error("--changing, --with-weights and --identity-out go with --with");
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
        weights = read_weights(settings.weights, "weight");
        options.set_weights(weights);
    }
    const std::vector<std::uint32_t> treated = zone_vertices(settings.zones, settings.treated);
    options.set_treated(treated);
    options.treated_margin_mm = settings.margin;
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
    if (report.contains("treated_zone")) print_readings(report["treated_zone"]);
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
    std::string model, data, against, fit = "mixture", against_fit = "alternating", zones, zone,
                                      stable, picture;
    int sweeps = 200, against_sweeps = 3;
};

void print_row(const nlohmann::json& row, bool compared) {
    auto number = [](const nlohmann::json& value) {
        return value.is_number() ? value.get<double>() : std::nan("");
    };
    std::printf("%-16.16s %5.2f (%4.2f) %5.2f (%4.2f)",
                row["expression"].get<std::string>().c_str(),
                row["baseline"]["mean_mm"].get<double>(), row["baseline"]["sd_mm"].get<double>(),
                row["result"]["mean_mm"].get<double>(), row["result"]["sd_mm"].get<double>());
    if (compared)
        std::printf(" %5.2f (%4.2f)", row["against"]["mean_mm"].get<double>(),
                    row["against"]["sd_mm"].get<double>());
    const nlohmann::json& effect = row[compared ? "effect_over_against" : "effect_over_baseline"];
    std::printf(" %7.2f %6.1f\n", number(effect["cohens_d"]), 100 * number(effect["superiority"]));
}

/// Absolute volume to the neutral face per zone, means over the faces of an expression.
void print_volumes(const nlohmann::json& report, bool compared) {
    if (!report["all"].contains("volumes") || report["all"]["volumes"].empty()) return;
    const std::size_t zones = report["all"]["volumes"].size();
    for (std::size_t z = 0; z < zones; ++z) {
        std::printf("\n%-16.16s %14s %14s%s   mL (sd)\n",
                    report["all"]["volumes"][z]["zone"].get<std::string>().c_str(), "untouched",
                    "result", compared ? "        against" : "");
        const auto row = [&](const nlohmann::json& expression) {
            const nlohmann::json& volume = expression["volumes"][z];
            std::printf("%-16.16s", expression["expression"].get<std::string>().c_str());
            for (const char* key : {"baseline", "result", "against"})
                if (volume.contains(key))
                    std::printf(" %6.2f (%5.2f)", volume[key]["mean_ml"].get<double>(),
                                volume[key]["sd_ml"].get<double>());
            std::printf("\n");
        };
        for (const nlohmann::json& expression : report["expressions"]) row(expression);
        row(report["all"]);
    }
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
    std::vector<std::pair<std::string, std::vector<std::uint32_t>>> measured;
    if (!settings.zones.empty()) measured = read_zones(settings.zones, {"lips"});
    std::vector<mien_zone> volume_zones;
    for (auto& [name, vertices] : measured) {
        keep_below(vertices, model.vertex_count());
        if (!vertices.empty())
            volume_zones.push_back({name.c_str(), vertices.data(), vertices.size()});
    }
    options.volume_zones = volume_zones.data();
    options.volume_zone_count = volume_zones.size();
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
    print_volumes(report, compared);
    if (!settings.picture.empty()) draw_table(settings.picture, report, compared);
    report["model"] = settings.model;
    report["data"] = settings.data;
    report["fit"] = settings.fit;
    if (compared) report["against"] = settings.against;
    write_report(settings.common, report);
}

void add_neutralize(CLI::App& app) {
    auto settings = std::make_shared<NeutralizeSettings>();
    CLI::App* neutralize =
        app.add_subcommand("neutralize", "take the expression off a fitted face");
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
    neutralize
        ->add_option("--pose", settings->pose, "where the face lies against the training faces")
        ->check(one_of(kPoses))
        ->capture_default_str();
    neutralize
        ->add_option(
            "--weights", settings->weights,
            "registration report (mien register --json) or a list: how much each vertex counts")
        ->check(CLI::ExistingFile);
    neutralize->add_option("--scan", settings->scan, "the scan that the face was fitted to")
        ->check(CLI::ExistingFile);
    neutralize->add_option("--scan-out", settings->scan_out, "the scan, neutralized");
    neutralize
        ->add_option("--max-distance", settings->max_distance,
                     "scan vertices farther from the face move with their neighbourhood, mm")
        ->capture_default_str();
    neutralize
        ->add_option("--with", settings->with,
                     "more faces of the same person: one identity for all")
        ->check(CLI::ExistingFile);
    neutralize
        ->add_option("--with-weights", settings->with_weights,
                     "weights of these faces, in their order")
        ->check(CLI::ExistingFile);
    neutralize->add_option("--with-out", settings->with_out,
                           "neutral faces of these faces, in their order");
    neutralize->add_option("--zones", settings->zones, "zone file, for --treated and --changing")
        ->check(CLI::ExistingFile);
    neutralize->add_option(
        "--treated", settings->treated,
        "zones (comma between) where the person may have been treated: no witness of expression");
    neutralize->add_option("--margin", settings->margin, "around treated zones, mm")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    neutralize->add_option(
        "--changing", settings->changing,
        "zones (comma between) where the person may change between the faces: a treated zone");
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
    CLI::App* evaluate =
        group->add_subcommand("neutralization", "errors of neutralization over a dataset");
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
    add_neutralize(app);
    add_evaluate(app);
}

}  // namespace mien::cli
