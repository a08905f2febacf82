// mien network info|encode|decode|apply|mix|sample|compare: trained networks on fitted faces.
#include <algorithm>
#include <cstdio>

#include "commands.hpp"
#include "plot.hpp"

namespace mien::cli {
namespace {

struct NetworkCommand {
    Common common;
    std::string network, in, out, code, data, subjects, picture;
    std::vector<std::string> networks;
    bool neutral = false, distances_only = false;
    std::string other;                   // of mix: the second face
    std::vector<double> weights{1, 1};   // of mix: of the bands
    std::uint64_t seed = 1, number = 0;  // of sample
    double spread = 1;
    std::int64_t k = 0;  // of apply: mien_network_options.band_limit
    bool deformations_only = false;
};

void print_network_layers(const nlohmann::json& network, const std::string& prefix) {
    for (const char* part : {"encoder", "decoder"})
        for (const nlohmann::json& layer : network[part])
            std::printf("  %-13s %-9s %8llu x %-4llu%s\n", (prefix + part).c_str(),
                        layer["kind"].get<std::string>().c_str(),
                        layer["rows"].get<unsigned long long>(),
                        layer["channels"].get<unsigned long long>(),
                        layer["elu"].get<bool>() ? "  ELU" : "");
}

void run_network_info(const NetworkCommand& settings) {
    const Session session(settings.common.num_threads);
    const nlohmann::json report =
        nlohmann::json::parse(Network::load(session, settings.network).json());
    std::printf("%s: %llu vertices, codes of %llu numbers, %s to %s\n",
                report["name"].get<std::string>().c_str(),
                report["vertices"].get<unsigned long long>(),
                report["code"].get<unsigned long long>(),
                report["input_features"].get<std::string>().c_str(),
                report["output_features"].get<std::string>().c_str());
    std::printf("%.2f million weights; million multiply-adds: encoder %.1f, decoder %.1f\n",
                1e-6 * report["weights"].get<double>(),
                1e-6 * report["encoder_multiply_adds"].get<double>(),
                1e-6 * report["decoder_multiply_adds"].get<double>());
    if (report["task"] == "displacement") std::printf("adds an expression to a neutral face\n");
    if (!report.contains("bands")) {
        print_network_layers(report, "");
    } else {
        std::printf("two bands at %llu of %llu modes; decoders conditioned by %g\n",
                    report["band_limit"].get<unsigned long long>(),
                    report["modes"].get<unsigned long long>(),
                    report["conditioning"].get<double>());
        print_network_layers(report["bands"][0], "low ");
        print_network_layers(report["bands"][1], "high ");
    }
    write_report(settings.common, report);
}

void run_encode(const NetworkCommand& settings) {
    const Session session(settings.common.num_threads);
    const Network network = Network::load(session, settings.network);
    Network::Motion motion;
    const std::vector<double> code = network.encode(session, Mesh(session, settings.in), &motion);
    write_json(settings.out, {{"code", code}, {"motion", motion}});
    write_report(settings.common, {{"in", settings.in}, {"out", settings.out}, {"code", code}});
}

std::vector<double> numbers_of(const nlohmann::json& file, const std::string& path,
                               const char* key) {
    if (!file.is_object() || !file.contains(key) || !file[key].is_array())
        throw std::runtime_error(path + ": expected {\"" + key + "\": [number, ...]}");
    std::vector<double> numbers;
    for (const nlohmann::json& value : file[key]) {
        if (!value.is_number())
            throw std::runtime_error(path + ": '" + key + "' holds " + value.dump() +
                                     ", which is no number");
        numbers.push_back(value.get<double>());
    }
    return numbers;
}

void run_decode(const NetworkCommand& settings) {
    const nlohmann::json file = read_json(settings.code);
    const std::vector<double> code = numbers_of(file, settings.code, "code");
    Network::Motion motion;
    const bool placed = file.contains("motion");
    if (placed) {
        const std::vector<double> given = numbers_of(file, settings.code, "motion");
        if (given.size() != motion.size())
            throw std::runtime_error(settings.code + ": 'motion' has " +
                                     std::to_string(given.size()) +
                                     " numbers; give the 12 of 'mien network encode', or none");
        std::copy(given.begin(), given.end(), motion.begin());
    }
    const Session session(settings.common.num_threads);
    Network::load(session, settings.network)
        .decode(session, code, placed ? &motion : nullptr)
        .save(session, settings.out);
    write_report(settings.common, {{"code", settings.code}, {"out", settings.out}});
}

void run_apply(const NetworkCommand& settings) {
    const Session session(settings.common.num_threads);
    const Network network = Network::load(session, settings.network);
    const Mesh face(session, settings.in);
    const Mesh result =
        network.apply(session, face, nullptr, settings.deformations_only ? -1 : settings.k);
    result.save(session, settings.out);
    const double l1 = metric(session, MIEN_METRIC_L1, face, result);
    const double l2 = metric(session, MIEN_METRIC_L2, face, result);
    std::printf("from the face: L1 %.3f mm, L2 %.3f mm\n", l1, l2);
    write_report(settings.common,
                 {{"in", settings.in}, {"out", settings.out}, {"l1_mm", l1}, {"l2_mm", l2}});
}

void run_network_mix(const NetworkCommand& settings) {
    const Session session(settings.common.num_threads);
    const Network network = Network::load(session, settings.network);
    if (settings.weights.size() > 2 || settings.weights.empty())
        throw CLI::ValidationError("--weights", "give one number, or one for each band: low, high");
    if (settings.weights.size() == 2 && network.band_limit() < 0)
        throw CLI::ValidationError("--weights", "this network has no bands; give one number");
    network
        .mix(session, Mesh(session, settings.in), Mesh(session, settings.other),
             settings.weights.front(), settings.weights.back())
        .save(session, settings.out);
    write_report(settings.common, {{"in", settings.in},
                                   {"with", settings.other},
                                   {"weights", settings.weights},
                                   {"out", settings.out}});
}

void run_network_sample(const NetworkCommand& settings) {
    const Session session(settings.common.num_threads);
    const Network network = Network::load(session, settings.network);
    const std::vector<double> code =
        network.sample(settings.seed, settings.number, settings.spread);
    network.decode(session, code).save(session, settings.out);
    if (!settings.code.empty()) write_json(settings.code, {{"code", code}});
    write_report(settings.common, {{"seed", settings.seed},
                                   {"number", settings.number},
                                   {"spread", settings.spread},
                                   {"code", code},
                                   {"out", settings.out}});
}

std::vector<std::int32_t> read_subjects(const std::string& path) {
    std::vector<std::int32_t> subjects;
    if (path.empty()) return subjects;
    const nlohmann::json file = read_json(path);
    const nlohmann::json& list = file.is_object() && file.contains("test") ? file["test"] : file;
    if (!list.is_array() || list.empty())
        throw std::runtime_error(path + ": expected [subject, ...] or {\"test\": [subject, ...]}");
    for (const nlohmann::json& value : list) {
        if (!value.is_number_integer())
            throw std::runtime_error(path + ": " + value.dump() + " is not a subject's number");
        subjects.push_back(value.get<std::int32_t>());
    }
    return subjects;
}

/// Marks the rows that no other row beats in both L1 and DAME.
void mark_front(nlohmann::json& rows) {
    for (nlohmann::json& row : rows) {
        const auto beats = [&](const nlohmann::json& other) {
            return other["l1_mm"] <= row["l1_mm"] && other["dame"] <= row["dame"] &&
                   (other["l1_mm"] < row["l1_mm"] || other["dame"] < row["dame"]);
        };
        row["on_front"] = std::none_of(rows.begin(), rows.end(), beats);
    }
}

void draw_comparison(const std::string& path, const nlohmann::json& rows) {
    std::vector<Curve> curves;
    std::vector<std::pair<double, double>> front;
    for (const nlohmann::json& row : rows) {
        Curve point;
        point.label = row["name"].get<std::string>();
        point.x = {row["l1_mm"].get<double>()};
        point.y = {row["dame"].get<double>()};
        point.markers = true;
        point.line = false;
        curves.push_back(point);
        if (row["on_front"].get<bool>()) front.emplace_back(point.x[0], point.y[0]);
    }
    std::sort(front.begin(), front.end());
    Curve line;
    line.label = "Pareto front";
    for (const auto& [x, y] : front) {
        line.x.push_back(x);
        line.y.push_back(y);
    }
    curves.push_back(line);
    PlotOptions plot;
    plot.title = "faces given back";
    plot.x_label = "L1, mm";
    plot.y_label = "DAME, rad";
    write_png(path, draw_plot(curves, plot));
}

/// Says in words when the linear model of the same size is the best of all.
void print_winner(const nlohmann::json& rows) {
    const auto best = std::min_element(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
        return a["l1_mm"] < b["l1_mm"];
    });
    const std::string name = (*best)["name"];
    if (rows.size() > 1)
        std::printf("least L1: %s%s\n", name.c_str(),
                    name == "pca" ? "; no network beats the linear model on these faces" : "");
}

void run_compare(const NetworkCommand& settings) {
    const Session session(settings.common.num_threads);
    Network::Evaluation what;
    what.neutral_only = settings.neutral;
    what.perceptual = !settings.distances_only;
    what.subjects = read_subjects(settings.subjects);
    what.progress = progress_bar();
    nlohmann::json rows = nlohmann::json::array();
    std::printf("%-28s %5s %8s %8s %8s %8s %8s\n", "", "code", "weights", "L1 mm", "L2 mm", "DAME",
                "FMPD");
    for (const std::string& path : settings.networks) {
        const Network network = Network::load(session, path);
        const nlohmann::json info = nlohmann::json::parse(network.json());
        nlohmann::json row = nlohmann::json::parse(network.evaluate(session, settings.data, what));
        row["name"] = info["name"];
        row["file"] = path;
        row["code"] = info["code"];
        row["features"] = info["output_features"];
        row["weights"] = info["weights"];
        std::printf("%-28s %5llu %7.2fM %8.4f %8.4f", info["name"].get<std::string>().c_str(),
                    info["code"].get<unsigned long long>(), 1e-6 * info["weights"].get<double>(),
                    row["l1_mm"].get<double>(), row["l2_mm"].get<double>());
        if (what.perceptual)
            std::printf(" %8.4f %8.4f", row["dame"].get<double>(), row["fmpd"].get<double>());
        std::printf("\n");
        rows.push_back(std::move(row));
    }
    print_winner(rows);
    if (what.perceptual) mark_front(rows);
    if (!settings.picture.empty()) {
        if (!what.perceptual)
            throw std::runtime_error("--picture draws L1 against DAME: leave --distances-only out");
        draw_comparison(settings.picture, rows);
    }
    write_report(settings.common, {{"data", settings.data}, {"networks", rows}});
}

using NetworkSettings = std::shared_ptr<NetworkCommand>;

CLI::App* add_use(CLI::App* network, const NetworkSettings& settings, const char* name,
                  const char* what) {
    CLI::App* command = network->add_subcommand(name, what);
    command->add_option("--network", settings->network, "network file of mien-train")->required();
    add_common_options(*command, settings->common);
    return command;
}

void add_network_mix(CLI::App* network, const NetworkSettings& settings) {
    CLI::App* mix = add_use(network, settings, "mix",
                            "a face between two, or with the low frequencies of one and the high "
                            "ones of the other");
    mix->add_option("--in", settings->in, "first face, weight 0; the result stands where it does")
        ->required();
    mix->add_option("--with", settings->other, "second face, weight 1")->required();
    mix->add_option("--weights", settings->weights,
                    "how far towards the second face: one number, or one each for the low and the "
                    "high band")
        ->required()
        ->delimiter(',');
    mix->add_option("--out", settings->out, "mesh")->required();
    mix->footer(
        "Example: mien network mix --network bands.safetensors --in a.ply --with b.ply --weights 0 "
        "1 --out a_with_details_of_b.ply");
    mix->callback([settings] { run_network_mix(*settings); });
}

void add_network_sample(CLI::App* network, const NetworkSettings& settings) {
    CLI::App* sample =
        add_use(network, settings, "sample", "a made-up face, as the training faces' codes vary");
    sample->add_option("--seed", settings->seed, "of the chance")->capture_default_str();
    sample->add_option("--number", settings->number, "which face of the seed's series")
        ->capture_default_str();
    sample->add_option("--spread", settings->spread, "0 the mean code, 1 as the training faces")
        ->capture_default_str();
    sample->add_option("--out", settings->out, "mesh")->required();
    sample->add_option("--code", settings->code, "JSON file for the code, to edit and decode");
    sample->footer(
        "Example: mien network sample --network bands.safetensors --seed 7 --out made_up.ply");
    sample->callback([settings] { run_network_sample(*settings); });
}

void add_compare(CLI::App* network, const NetworkSettings& settings) {
    CLI::App* compare =
        network->add_subcommand("compare", "how well networks give back faces of a dataset");
    compare->add_option("--networks", settings->networks, "network files")->required();
    compare->add_option("--data", settings->data, "dataset of faces in correspondence")->required();
    compare->add_option("--subjects", settings->subjects,
                        "[subject, ...] or {\"test\": [...]}; default: all. Take people that the "
                        "networks were not trained on");
    compare->add_flag("--neutral", settings->neutral, "only the faces marked neutral");
    compare->add_flag("--distances-only", settings->distances_only, "without DAME and FMPD");
    compare->add_option("--picture", settings->picture,
                        "PNG: L1 against DAME with the Pareto front");
    add_common_options(*compare, settings->common);
    compare->footer(
        "Example: mien network compare --networks pca.safetensors spiralnet.safetensors --data "
        "faces.safetensors --subjects split.json --picture compare.png");
    compare->callback([settings] { run_compare(*settings); });
}

}  // namespace

void add_network_commands(CLI::App& app) {
    CLI::App* network = app.add_subcommand("network", "trained networks: faces to codes and back");
    network->require_subcommand(1);
    const auto settings = std::make_shared<NetworkCommand>();
    CLI::App* info = add_use(network, settings, "info", "what a network is: layers, sizes, costs");
    info->footer("Example: mien network info --network spiralnet.safetensors");
    info->callback([settings] { run_network_info(*settings); });

    CLI::App* encode = add_use(network, settings, "encode", "the code of a fitted face");
    encode->add_option("--in", settings->in, "fitted face")->required();
    encode->add_option("--out", settings->out, "JSON: code, and the motion onto the mean")
        ->required();
    encode->footer(
        "Example: mien network encode --network spiralnet.safetensors --in fitted.ply --out "
        "code.json");
    encode->callback([settings] { run_encode(*settings); });

    CLI::App* decode = add_use(network, settings, "decode", "the face of a code");
    decode
        ->add_option("--code", settings->code,
                     "{\"code\": [...], \"motion\": [12 numbers]}; "
                     "without motion in the mean's frame")
        ->required();
    decode->add_option("--out", settings->out, "mesh")->required();
    decode->footer(
        "Example: mien network decode --network spiralnet.safetensors --code code.json --out "
        "face.ply");
    decode->callback([settings] { run_decode(*settings); });

    CLI::App* apply =
        add_use(network, settings, "apply", "a face encoded and decoded, in its own frame");
    apply->add_option("--in", settings->in, "fitted face")->required();
    apply->add_option("--out", settings->out, "mesh")->required();
    apply->footer(
        "Example: mien network apply --network spiralnet.safetensors --in fitted.ply --out "
        "back.ply");
    auto* modes = apply->add_option("--k", settings->k,
                                    "of a network that adds an expression in two bands: modes of "
                                    "the low one; default: the file's own");
    modes->check(CLI::PositiveNumber);
    apply
        ->add_flag("--deformations-only", settings->deformations_only,
                   "of such a network: no low band, the deformations' face alone")
        ->excludes(modes);
    apply->callback([settings] { run_apply(*settings); });
    add_network_mix(network, settings);
    add_network_sample(network, settings);
    add_compare(network, settings);
}

}  // namespace mien::cli
