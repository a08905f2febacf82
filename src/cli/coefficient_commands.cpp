// mien model fit|synthesize|condition: coefficients of a model from a face, faces from
// coefficients, and what a model may still do once landmarks were seen.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>

#include "commands.hpp"
#include "fields.hpp"

namespace mien::cli {
namespace {

/// {"scalar": [[x, y, z], ...], "trained": [c, ...]} of a flat list.
nlohmann::json coefficients_json(const std::vector<double>& values, std::size_t scalar_modes) {
    nlohmann::json scalar = nlohmann::json::array(), trained = nlohmann::json::array();
    for (std::size_t j = 0; j < scalar_modes; ++j)
        scalar.push_back({values[3 * j], values[3 * j + 1], values[3 * j + 2]});
    for (std::size_t i = 3 * scalar_modes; i < values.size(); ++i) trained.push_back(values[i]);
    return {{"scalar", scalar}, {"trained", trained}};
}

/// The flat list of such a file; rows or values that it leaves out are zero.
std::vector<double> read_coefficients(const std::string& path, const Model& model) {
    const nlohmann::json file = read_json(path);
    const std::size_t scalar_modes = model.scalar_modes(), trained_modes = model.vector_modes();
    std::vector<double> values(3 * scalar_modes + trained_modes, 0.0);
    try {
        const auto scalar = file.value("scalar", std::vector<std::array<double, 3>>());
        const auto trained = file.value("trained", std::vector<double>());
        if (scalar.size() > scalar_modes || trained.size() > trained_modes)
            throw std::runtime_error(path + ": holds " + std::to_string(scalar.size()) + " and " +
                                     std::to_string(trained.size()) +
                                     " coefficients, the model has " +
                                     std::to_string(scalar_modes) + " scalar and " +
                                     std::to_string(trained_modes) + " trained modes");
        for (std::size_t j = 0; j < scalar.size(); ++j)
            for (std::size_t c = 0; c < 3; ++c) values[3 * j + c] = scalar[j][c];
        for (std::size_t j = 0; j < trained.size(); ++j) values[3 * scalar_modes + j] = trained[j];
    } catch (const nlohmann::json::exception&) {
        throw std::runtime_error(
            path + ": expected {\"scalar\": [[x, y, z], ...], \"trained\": [c, ...]}");
    }
    return values;
}

/// Distance of each vertex of `made` from the same one of `target`, which may have fewer.
std::vector<double> distances_to(const Mesh& made, const Mesh& target) {
    const auto a = made.positions(), b = target.positions();
    std::vector<double> field(a.size(), std::nan(""));
    for (std::size_t v = 0; v < std::min(a.size(), b.size()); ++v)
        field[v] = std::hypot(std::hypot(a[v][0] - b[v][0], a[v][1] - b[v][1]), a[v][2] - b[v][2]);
    return field;
}

struct FitCommand {
    Common common;
    std::string model, target, record, weights, out, mesh_out, picture;
    ModelFitSettings settings;
};

void run_fit(FitCommand& o) {
    if (o.target.empty() == o.record.empty())
        throw CLI::ValidationError("model fit", "give either --target or --fit");
    const bool has_residual = !o.target.empty() && !o.settings.align;
    if (!o.picture.empty() && !has_residual)
        throw CLI::ValidationError("--picture",
                                   "shows a residual, which --align and --fit have not");
    const Session session(o.common.num_threads);
    const Model model(session, o.model);
    if (!o.weights.empty()) o.settings.weights = read_weights(o.weights, "weight");
    std::vector<double> values;
    if (!o.record.empty()) {
        values =
            coefficients_of(session, Registration(session, o.record), model, o.settings.ridge_mm2);
    } else {
        values = fit_model(session, model, Mesh(session, o.target), o.settings);
    }
    const Mesh face = synthesize(session, model, values);
    nlohmann::json report = coefficients_json(values, model.scalar_modes());
    double square = 0;
    for (const double value : values) square += value * value;
    report["norm"] = std::sqrt(square);
    report["ridge_mm2"] = o.settings.ridge_mm2;
    std::printf("%zu coefficients, norm %.4g\n", values.size(), std::sqrt(square));
    if (has_residual) {
        const std::vector<double> residual = distances_to(face, Mesh(session, o.target));
        const FieldSummary summary = summary_of(residual);
        report["residual_mm"] = summary_json(summary);
        std::printf("residual: mean %.4g mm, largest %.4g mm\n", summary.mean, summary.most);
        draw_field(o.picture, face, residual, {"residual, mm", "", false, 0.0, {}});
    }
    if (!o.out.empty()) write_json(o.out, coefficients_json(values, model.scalar_modes()));
    if (!o.mesh_out.empty()) face.save(session, o.mesh_out);
    write_report(o.common, report);
}

void add_fit(CLI::App& parent) {
    auto o = std::make_shared<FitCommand>();
    CLI::App& command = *parent.add_subcommand(
        "fit", "coefficients of a face whose correspondence is known, or of a kept registration");
    command.add_option("model", o->model, "model file")->required();
    command.add_option("--target", o->target, "face in the template's correspondence and frame");
    command.add_option("--fit", o->record, "record of `mien register --record`");
    command.add_option("--ridge", o->settings.ridge_mm2, "variance of the target's noise, mm^2")
        ->capture_default_str();
    command.add_option("--weights", o->weights,
                       "JSON list of one weight per vertex of the target, or a report of register");
    command
        .add_option("--scalar-modes", o->settings.scalar_modes, "the first scalar modes, -1: all")
        ->capture_default_str();
    command
        .add_option("--trained-modes", o->settings.vector_modes, "the first trained modes, -1: all")
        ->capture_default_str();
    command.add_flag("--align", o->settings.align, "move the target rigidly onto the mean first");
    command.add_option("--out", o->out, "coefficients, JSON");
    command.add_option("--mesh-out", o->mesh_out, "the face of the coefficients");
    command.add_option("--picture", o->picture, "PNG of the residual");
    add_common_options(command, o->common);
    command.footer(
        "Example: mien model fit face.safetensors --target smile.ply --ridge 1 --out alpha.json "
        "--mesh-out nearest.ply --picture residual.png");
    command.callback([o] { run_fit(*o); });
}

void add_synthesize(CLI::App& parent) {
    struct Settings {
        Common common;
        std::string model, coefficients, out;
    };
    auto o = std::make_shared<Settings>();
    CLI::App& command = *parent.add_subcommand("synthesize", "the face of given coefficients");
    command.add_option("model", o->model, "model file")->required();
    command
        .add_option("--coefficients", o->coefficients,
                    "JSON {\"scalar\": [[x, y, z], ...], \"trained\": [c, ...]}, as model fit "
                    "writes; what is left out is zero")
        ->required();
    command.add_option("--out", o->out, "mesh to write")->required();
    add_common_options(command, o->common);
    command.footer(
        "Example: mien model synthesize face.safetensors --coefficients alpha.json --out face.ply");
    command.callback([o] {
        const Session session(o->common.num_threads);
        const Model model(session, o->model);
        synthesize(session, model, read_coefficients(o->coefficients, model)).save(session, o->out);
        write_report(o->common, {{"out", o->out}});
    });
}

struct ConditionCommand {
    Common common;
    std::string model, landmarks, out, mean_out, field, picture;
    double noise = 1;
    std::vector<std::string> noise_of;
};

/// "pronasale:0.5": the noise of one landmark.
std::map<std::string, double> parse_noises(const std::vector<std::string>& texts) {
    std::map<std::string, double> noises;
    for (const std::string& text : texts) {
        const std::size_t colon = text.rfind(':');
        try {
            std::size_t used = 0;
            if (colon == std::string::npos || colon == 0) throw std::invalid_argument("");
            const std::string number = text.substr(colon + 1);
            noises[text.substr(0, colon)] = std::stod(number, &used);
            if (used != number.size()) throw std::invalid_argument("");
        } catch (const std::logic_error&) {
            throw CLI::ValidationError("--noise-of", text +
                                                         ": expected NAME:MM, for example "
                                                         "pronasale:0.5");
        }
    }
    return noises;
}

/// Standard deviation of a vertex per axis, mm.
std::vector<double> deviations(const Model& model) {
    std::vector<double> field;
    for (const Position& v : model.variance()) field.push_back(std::sqrt((v[0] + v[1] + v[2]) / 3));
    return field;
}

void run_condition(const ConditionCommand& o) {
    const Session session(o.common.num_threads);
    const Model prior(session, o.model);
    std::map<std::string, double> noises = parse_noises(o.noise_of);
    const Landmarks picked = Landmarks(session, o.landmarks).match(prior);
    warn_of_unknown_landmarks(picked, o.landmarks);
    std::vector<LandmarkObservation> seen;
    std::vector<Position> dots;
    const nlohmann::json known = nlohmann::json::parse(prior.json())["landmarks"];
    for (const NamedPoint& point : picked_points(picked, o.landmarks)) {
        if (!known.contains(point.name)) continue;
        const auto own = noises.find(point.name);
        seen.push_back({point.name, point.point, own != noises.end() ? own->second : o.noise});
        if (own != noises.end()) noises.erase(own);
        dots.push_back(point.point);
    }
    if (seen.empty()) throw std::runtime_error(o.landmarks + ": no landmark of the model is in it");
    if (!noises.empty())
        throw std::runtime_error("--noise-of " + noises.begin()->first +
                                 ": no such landmark was seen");
    const Model posterior = prior.condition(session, seen);
    posterior.save(session, o.out);
    const FieldSummary before = summary_of(deviations(prior));
    const std::vector<double> field = deviations(posterior);
    const FieldSummary after = summary_of(field);
    std::printf("%zu landmarks\n%-12s %10s %10s %10s   deviation per axis, mm\n", seen.size(), "",
                "least", "mean", "largest");
    std::printf("%-12s %10.4f %10.4f %10.4f\n", "prior", before.least, before.mean, before.most);
    std::printf("%-12s %10.4f %10.4f %10.4f\n", "posterior", after.least, after.mean, after.most);
    const Mesh mean = posterior.sample(session, 0, 0, 0);
    if (!o.mean_out.empty()) mean.save(session, o.mean_out);
    if (!o.field.empty()) write_json(o.field, field);
    draw_field(o.picture, mean, field,
               {"deviation per axis, mm", "posterior mean", false, 0.0, dots});
    nlohmann::json observed = nlohmann::json::array();
    for (const LandmarkObservation& one : seen)
        observed.push_back(
            {{"name", one.name}, {"position_mm", one.position}, {"noise_mm", one.noise_mm}});
    write_report(o.common, {{"landmarks", observed},
                            {"prior_deviation_mm", summary_json(before)},
                            {"posterior_deviation_mm", summary_json(after)},
                            {"out", o.out}});
}

void add_condition(CLI::App& parent) {
    auto o = std::make_shared<ConditionCommand>();
    CLI::App& command = *parent.add_subcommand(
        "condition", "the posterior model once landmarks were seen; sample it like any other");
    command.add_option("model", o->model, "model file")->required();
    command
        .add_option("--landmarks", o->landmarks,
                    "where landmarks of the model were seen, in the template's frame, mm")
        ->required();
    command.add_option("--noise", o->noise, "deviation of each landmark, mm")
        ->capture_default_str();
    command.add_option("--noise-of", o->noise_of, "NAME:MM, the deviation of one landmark")
        ->take_all();
    command.add_option("--out", o->out, "posterior model file to write")->required();
    command.add_option("--mean-out", o->mean_out, "mesh of the posterior mean");
    command.add_option("--field", o->field, "JSON list of the deviation per vertex, mm");
    command.add_option("--picture", o->picture, "PNG of the deviation on the posterior mean");
    add_common_options(command, o->common);
    command.footer(
        "Example: mien model condition face.safetensors --landmarks picked.json --noise 1 "
        "--noise-of pronasale:0.3 --out posterior.safetensors --picture deviation.png");
    command.callback([o] { run_condition(*o); });
}

}  // namespace

void add_coefficient_commands(CLI::App& model) {
    add_fit(model);
    add_synthesize(model);
    add_condition(model);
}

}  // namespace mien::cli
