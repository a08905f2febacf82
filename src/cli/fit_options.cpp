#include "fit_options.hpp"

#include <algorithm>
#include <cstdio>

namespace mien::cli {
namespace {

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

int choice(const std::string& value, const std::vector<std::string>& names) {
    return static_cast<int>(std::find(names.begin(), names.end(), value) - names.begin());
}

/// Which places of the scan the template's vertices stand for.
void add_correspondence_options(CLI::App& command, FitArguments& arguments) {
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

void add_fit_options(CLI::App& command, FitArguments& arguments, CLI::Option* landmarks) {
    command.add_option("--landmark-sigma", arguments.landmark_sigma, "picking error in mm")
        ->needs(landmarks)
        ->capture_default_str();
    command
        .add_option("--weights", arguments.weights,
                    "skin, none, or a JSON list with one weight per scan vertex")
        ->capture_default_str();
    command.add_option("--growth", arguments.growth, "how modes grow over the rounds")
        ->check(CLI::IsMember({"constant", "linear", "exponential", "cubic"}))
        ->capture_default_str();
    command
        .add_option("--units", arguments.units,
                    "detect the scan's unit, name it (mm, cm, dm, m, km, in, ft, or the mm that "
                    "one unit is long), or refuse all but mm")
        ->capture_default_str();
    command
        .add_flag("--mend-landmarks", arguments.mend_landmarks,
                  "exchange landmarks back whose left and right are exchanged")
        ->needs(landmarks);
    command.add_option("--start", arguments.start, "where the fit begins")
        ->check(CLI::IsMember({"automatic", "landmarks", "search"}))
        ->capture_default_str();
    command.add_option("--max-modes", arguments.max_modes, "scalar kernel modes used, -1: all")
        ->check(CLI::Range(-1, 1000000))
        ->capture_default_str();
    command.add_option("--max-pca-modes", arguments.max_pca_modes, "trained modes used, -1: all")
        ->check(CLI::Range(-1, 1000000))
        ->capture_default_str();
    command.add_option("--iterations", arguments.iterations, "rounds, 0: the library's choice")
        ->capture_default_str();
    add_correspondence_options(command, arguments);
    command.add_flag("--no-close-gap", arguments.no_close_gap, "stay within the span of the model");
    command.add_flag("--no-colors", arguments.no_colors,
                     "go by the form alone, not by lips and brows");
    command.add_flag("--accept-failed", arguments.accept_failed,
                     "exit with 0 even when the fit is judged failed");
}

RegisterOptions register_options(const FitArguments& arguments) {
    RegisterOptions options;
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
    return options;
}

nlohmann::json add_landmarks(const Session& session, const Model& model, const std::string& path,
                             RegisterOptions& options) {
    const Landmarks matched = Landmarks(session, path).match(model);
    const std::string warning = warn_of_unknown_landmarks(matched, path);
    for (const NamedPoint& point : picked_points(matched, path))
        options.landmarks.push_back({point.name, point.point});
    nlohmann::json report = nlohmann::json::parse(matched.json());
    report["warnings"] = nlohmann::json::array();
    if (!warning.empty()) report["warnings"].push_back(warning);
    // A fit without landmarks is another fit than the one that was asked for.
    if (options.landmarks.empty())
        throw std::runtime_error(
            path + ": none of its " + std::to_string(matched.size()) +
            " landmarks was picked (no place, or one place repeated for all); pick them, or "
            "leave --landmarks out");
    return report;
}

nlohmann::json fit_report(const Registration& fit, bool per_vertex) {
    nlohmann::json report = nlohmann::json::parse(fit.json());
    if (per_vertex) {
        report["residual_mm"] = fit.field(MIEN_REGISTRATION_RESIDUAL_MM);
        report["weight"] = fit.field(MIEN_REGISTRATION_WEIGHT);
        report["radius95_mm"] = fit.field(MIEN_REGISTRATION_RADIUS95_MM);
        report["standard_deviation_mm"] = fit.field(MIEN_REGISTRATION_STANDARD_DEVIATION_MM);
    }
    return report;
}

std::string first_reason(const nlohmann::json& report) {
    return report["reasons"].empty() ? "no reason stated" : report["reasons"][0];
}

std::string verdict_line(const nlohmann::json& report) {
    std::string line = "quality " + report["quality"].get<std::string>();
    for (const auto& reason : report["reasons"]) line += "; " + reason.get<std::string>();
    for (const auto& note : report["notes"]) line += "; note: " + note.get<std::string>();
    if (const double unit = report["unit_to_mm"]; unit != 1)
        line += "; unit of the scan: " + number_text(unit) + " mm";
    if (report.contains("expected_error") && report["expected_error"].contains("face"))
        line += "; expected error of the face " + error_text(report["expected_error"]["face"]);
    return line;
}

}  // namespace mien::cli
