// mien train: an expression model of a study's faces, whole or in parts.
#include <cstdio>

#include "commands.hpp"
#include "plot.hpp"

namespace mien::cli {
namespace {

struct TrainSettings {
    Common common;
    std::string data, out, method = "jpca", lambda = "auto", zones, stable, picture;
    std::string part, shard_out;
    std::vector<std::string> merge;
    int identity_modes = 0, expression_modes = 0, shard_rank = 512;
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
                                 settings.shard_rank, progress_bar(),
                                 zone_vertices(settings.zones, settings.stable));
    std::printf("%s: part %d of %d\n", settings.shard_out.c_str(), part + 1, count);
    write_report(settings.common, {{"data", settings.data},
                                   {"shard", settings.shard_out},
                                   {"part", part + 1},
                                   {"parts", count}});
}

/// Figure 4.6: how far the two subspaces are from orthogonal, per number of components.
void draw_orthogonality(const std::string& path, const nlohmann::json& report,
                        const std::string& method) {
    auto curve = [&](const char* label, const char* key) {
        Curve line;
        line.label = label;
        line.y = report[key].get<std::vector<double>>();
        for (std::size_t k = 0; k < line.y.size(); ++k)
            line.x.push_back(static_cast<double>(k + 1));
        return line;
    };
    std::vector<Curve> curves{curve("joint PCA", "joint_pca_orthogonality")};
    if (method == "qojpca") curves.push_back(curve("quasi-orthogonal joint PCA", "orthogonality"));
    PlotOptions options;
    options.title = "Orthogonality of identity and expression";
    options.x_label = "components of each";
    options.y_label = "score";
    options.zero_y = true;
    write_png(path, draw_plot(curves, options));
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
    for (const nlohmann::json& pair : report["tried_modes"])
        std::printf("  tried %d + %d: people left out %.4f mm\n", pair["identity"].get<int>(),
                    pair["expression"].get<int>(), pair["held_out_mm"].get<double>());
    if (report["skipped_faces"].get<int>() != 0)
        std::printf("%d faces left out: their subjects have no neutral face\n",
                    report["skipped_faces"].get<int>());
    if (settings.method == "qojpca")
        std::printf("lambda %.4g, %d iterations%s\n", report["lambda"].get<double>(),
                    report["iterations"].get<int>(),
                    report["converged"].get<bool>() ? "" : " (not converged)");
    if (!settings.picture.empty()) draw_orthogonality(settings.picture, report, settings.method);
    if (settings.merge.empty())
        report["data"] = settings.data;
    else
        report["shards"] = settings.merge;
    report["model"] = settings.out;
    write_report(settings.common, report);
}

void add_train(CLI::App& app) {
    auto settings = std::make_shared<TrainSettings>();
    CLI::App* train = app.add_subcommand("train", "learn an expression model from a study's faces");
    train->add_option("--data", settings->data, "dataset (safetensors)")->check(CLI::ExistingFile);
    train->add_option("--merge", settings->merge, "train from shards instead")
        ->check(CLI::ExistingFile);
    train->add_option("--part", settings->part, "K/N: write the shard of part K of the data only");
    train->add_option("--shard-out", settings->shard_out, "with --part: the shard file");
    train->add_option("--shard-rank", settings->shard_rank, "directions that a shard keeps")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    train->add_option("--method", settings->method, "how the subspaces are found")
        ->check(CLI::IsMember({"jpca", "qojpca"}))
        ->capture_default_str();
    train
        ->add_option("--identity-modes", settings->identity_modes,
                     "0: of 25, 50, 75 and 100 the fewest that serve people left out")
        ->check(CLI::Range(0, 4000))
        ->capture_default_str();
    train->add_option("--expression-modes", settings->expression_modes, "0: as above")
        ->check(CLI::Range(0, 4000))
        ->capture_default_str();
    train->add_option("--lambda", settings->lambda, "qojpca: weight of orthogonality, or auto")
        ->capture_default_str();
    train->add_option("--zones", settings->zones, "zone file, for --stable")
        ->check(CLI::ExistingFile);
    train->add_option(
        "--stable", settings->stable,
        "zones (comma between) that every face is aligned on, for faces with posture");
    train->add_option("--picture", settings->picture,
                      "PNG: orthogonality per number of components");
    train->add_option("--out", settings->out, "model file");
    add_common_options(*train, settings->common);
    train->footer(
        "Example: mien train --data faces.safetensors --method jpca --out expr.safetensors");
    train->callback([settings] { run_train(*settings); });
}

}  // namespace

void add_training_commands(CLI::App& app) {
    add_train(app);
}

}  // namespace mien::cli
