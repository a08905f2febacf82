#include <algorithm>
#include <optional>

#include "commands.hpp"
#include "render.hpp"

namespace mien::cli {
namespace {

struct RegisterArguments {
    std::string model, scan, landmarks, weights = "none", growth = "constant", out, heatmap, record;
    double landmark_sigma = 2;
    std::string units = "detect", start = "automatic";
    int max_modes = -1, max_pca_modes = -1, iterations = 0;
    double max_distance = 0, mutual = 0, soft = 0;
    std::optional<double> max_angle;
    bool keep_border = false;
    bool no_close_gap = false, no_colors = false, mend_landmarks = false, accept_failed = false;
    Common common;
};

std::string number_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string error_text(const nlohmann::json& error) {
    char text[80];
    std::snprintf(text, sizeof text, "%.1f mm (%.1f to %.1f)", error["expected_mm"].get<double>(),
                  error["low_mm"].get<double>(), error["high_mm"].get<double>());
    return text;
}

std::string first_reason(const nlohmann::json& report) {
    return report["reasons"].empty() ? "no reason stated" : report["reasons"][0];
}

int choice(const std::string& value, const std::vector<std::string>& names) {
    return static_cast<int>(std::find(names.begin(), names.end(), value) - names.begin());
}

/// The fitted face coloured by its distance to the scan.
void write_heatmap(const std::string& path, const Registration& fit) {
    RenderOptions options;
    options.scalar = fit.field(MIEN_REGISTRATION_RESIDUAL_MM);
    options.color_map = ColorMap::diverging;
    options.low = -2;
    options.high = 2;
    options.label = "distance to the scan, mm";
    write_png(path, render_mesh(arrays_of(fit.mesh()), options));
}

void run_register(const RegisterArguments& arguments) {
    const Session session(arguments.common.num_threads);
    const Model model(session, arguments.model);
    const Mesh scan(session, arguments.scan);
    RegisterOptions options;
    nlohmann::json landmarks;
    if (!arguments.landmarks.empty()) {
        const Landmarks matched = Landmarks(session, arguments.landmarks).match(model);
        warn_of_unknown_landmarks(matched, arguments.landmarks);
        for (const NamedPoint& point : picked_points(matched, arguments.landmarks))
            options.landmarks.push_back({point.name, point.point});
        landmarks = nlohmann::json::parse(matched.json());
    }
    if (arguments.weights == "skin")
        options.c.skin_weights = 1;
    else if (arguments.weights != "none")
        options.scan_weights = read_weights(arguments.weights, "weights");
    options.c.growth = choice(arguments.growth, {"constant", "linear", "exponential", "cubic"});
    if (arguments.units == "detect" || arguments.units == "refuse")
        options.c.units = arguments.units == "detect" ? MIEN_UNITS_DETECT : MIEN_UNITS_REFUSE;
    else
        options.c.unit_to_mm = unit_in_mm(arguments.units);
    if (arguments.mend_landmarks) options.c.landmark_sides = MIEN_SIDES_MEND;
    options.c.start = choice(arguments.start, {"automatic", "landmarks", "pose", "search"});
    options.c.landmark_sigma_mm = arguments.landmark_sigma;
    options.c.max_scalar_modes = arguments.max_modes;
    options.c.max_pca_modes = arguments.max_pca_modes;
    options.c.iterations = arguments.iterations;
    if (arguments.max_angle) options.c.max_angle_deg = *arguments.max_angle;
    options.c.max_distance_mm = arguments.max_distance;
    options.c.mutual_mm = arguments.mutual;
    options.c.soft_mm = arguments.soft;
    if (arguments.keep_border) options.c.reject_border = 0;
    options.c.close_gap = arguments.no_close_gap ? 0 : 1;
    options.c.color_features = arguments.no_colors ? 0 : 1;
    options.progress = progress_bar();
    const Registration fit(session, model, scan, options);
    fit.mesh().save(session, arguments.out);
    nlohmann::json report = nlohmann::json::parse(fit.json());
    report["out"] = arguments.out;
    if (!landmarks.is_null()) report["landmark_file"] = landmarks;
    if (!arguments.common.json_path.empty()) {
        report["residual_mm"] = fit.field(MIEN_REGISTRATION_RESIDUAL_MM);
        report["weight"] = fit.field(MIEN_REGISTRATION_WEIGHT);
        report["radius95_mm"] = fit.field(MIEN_REGISTRATION_RADIUS95_MM);
        report["standard_deviation_mm"] = fit.field(MIEN_REGISTRATION_STANDARD_DEVIATION_MM);
    }
    write_report(arguments.common, report);
    if (!arguments.record.empty()) fit.save(session, arguments.record);
    if (!arguments.heatmap.empty()) write_heatmap(arguments.heatmap, fit);
    std::string line = "quality " + report["quality"].get<std::string>();
    for (const auto& reason : report["reasons"]) line += "; " + reason.get<std::string>();
    for (const auto& note : report["notes"]) line += "; note: " + note.get<std::string>();
    if (const double unit = report["unit_to_mm"]; unit != 1)
        line += "; unit of the scan: " + number_text(unit) + " mm";
    if (report.contains("expected_error") && report["expected_error"].contains("face"))
        line += "; expected error of the face " + error_text(report["expected_error"]["face"]);
    std::puts(line.c_str());
    if (report["quality"] == "failed" && !arguments.accept_failed)
        throw std::runtime_error(arguments.scan + ": the fit failed (" + first_reason(report) +
                                 "); its files are written; mend the cause, or give "
                                 "--accept-failed to go on with it");
}

/// Which places of the scan the template's vertices stand for.
void add_correspondence_options(CLI::App& command, RegisterArguments& arguments) {
    command.add_option("--max-angle", arguments.max_angle,
                       "degrees between the normals of a vertex and its place on the scan; the "
                       "library's choice when not given");
    command.add_flag("--keep-border", arguments.keep_border,
                     "let places on the scan's open border pull too");
    command
        .add_option("--max-distance", arguments.max_distance,
                    "mm beyond which a place does not pull, 0: as the noise level lets")
        ->capture_default_str();
    command
        .add_option("--mutual", arguments.mutual,
                    "mm that the vertex nearest to a place may lie from the one it pulls, 0: "
                    "not asked")
        ->capture_default_str();
    command
        .add_option("--soft", arguments.soft,
                    "deviation in mm of the Gaussian over the places that a vertex stands for, "
                    "0: the nearest alone")
        ->capture_default_str();
}

}  // namespace

void add_registration_commands(CLI::App& app) {
    auto* command = app.add_subcommand("register", "fit a model's template to a scan");
    auto arguments = std::make_shared<RegisterArguments>();
    command->add_option("--model", arguments->model, "deformation model")->required();
    command->add_option("--scan", arguments->scan, "mesh file: PLY, OBJ, STL, OFF, GLB, VTP or XYZ")
        ->required();
    command->add_option(
        "--landmarks", arguments->landmarks,
        "places on the scan: JSON {\"points\": {name: [x, y, z]}}, .mrk.json, .fcsv, .pp, "
        ".pts, .ljson, .csv");
    command->add_option("--landmark-sigma", arguments->landmark_sigma, "picking error in mm")
        ->capture_default_str();
    command
        ->add_option("--weights", arguments->weights,
                     "skin, none, or a JSON list with one weight per scan vertex")
        ->capture_default_str();
    command->add_option("--growth", arguments->growth, "how modes grow over the rounds")
        ->check(CLI::IsMember({"constant", "linear", "exponential", "cubic"}))
        ->capture_default_str();
    command
        ->add_option("--units", arguments->units,
                     "detect the scan's unit, name it (mm, cm, dm, m, km, in, ft, or the mm that "
                     "one unit is long), or refuse all but mm")
        ->capture_default_str();
    command->add_flag("--mend-landmarks", arguments->mend_landmarks,
                      "exchange landmarks back whose left and right are exchanged");
    command->add_option("--start", arguments->start, "where the fit begins")
        ->check(CLI::IsMember({"automatic", "landmarks", "search"}))
        ->capture_default_str();
    command->add_option("--max-modes", arguments->max_modes, "scalar kernel modes used, -1: all")
        ->capture_default_str();
    command->add_option("--max-pca-modes", arguments->max_pca_modes, "trained modes used, -1: all")
        ->capture_default_str();
    command->add_option("--iterations", arguments->iterations, "rounds, 0: the library's choice")
        ->capture_default_str();
    add_correspondence_options(*command, *arguments);
    command->add_flag("--no-close-gap", arguments->no_close_gap,
                      "stay within the span of the model");
    command->add_flag("--no-colors", arguments->no_colors,
                      "go by the form alone, not by lips and brows");
    command->add_flag("--accept-failed", arguments->accept_failed,
                      "exit with 0 even when the fit is judged failed");
    command->add_option("--out", arguments->out, "fitted template")->required();
    command->add_option("--record", arguments->record,
                        "keep the fit with its errors as a safetensors file, which report and "
                        "measure volume read in place of a mesh");
    command->add_option("--heatmap", arguments->heatmap, "PNG of the distance to the scan");
    add_common_options(*command, arguments->common);
    command->footer(
        "Example: mien register --model face.safetensors --scan scan.ply --out fitted.ply --json "
        "fit.json");
    command->callback([arguments] { run_register(*arguments); });
}

}  // namespace mien::cli
