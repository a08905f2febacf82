// mien measure anthropometry|norms|asymmetry: one face in; named measurements, or its left side
// against its right, out.
#include <cmath>
#include <cstdio>

#include "face_checks.hpp"
#include "measure_faces.hpp"
#include "render.hpp"

namespace mien::cli {
namespace {

struct FaceSettings {
    Common common;
    std::string mesh, fit_json, model, landmarks, norms, data, out, zones, field_path, picture,
        plane = "surface";
    std::optional<double> sd;
    bool all = false;
};

/// A file's landmarks, or a model's own with those of its profile.
Landmarks landmarks_of(const Session& session, const FaceSettings& settings) {
    if (!settings.landmarks.empty()) return Landmarks(session, settings.landmarks);
    if (settings.model.empty())
        throw std::runtime_error("give the landmarks: --landmarks, or --model for the model's own");
    const Model model(session, settings.model);
    Landmarks own = Landmarks::of(model);
    try {
        return with_profile(own, model.mesh());
    } catch (const Exception& failure) {
        if (failure.status() != MIEN_E_INVALID_MESH && failure.status() != MIEN_E_NOT_FOUND) throw;
        std::fprintf(stderr, "mien: without the landmarks of the profile: %s\n", failure.what());
        return own;
    }
}

std::string number(double value, int digits) {
    if (!std::isfinite(value)) return "-";
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

void print_measurement(const nlohmann::json& one, bool with_norms) {
    const auto value = [&](const char* key) {
        return one.contains(key) && one[key].is_number() ? one[key].get<double>() : std::nan("");
    };
    std::printf("%-22s %9s %8s %-8s", one["name"].get<std::string>().c_str(),
                number(value("value"), 2).c_str(), number(value("sd"), 2).c_str(),
                one["unit"].get<std::string>().c_str());
    if (with_norms)
        std::printf(" %7s +- %-6s", number(value("z"), 2).c_str(),
                    number(value("z_sd"), 2).c_str());
    std::printf(" %s\n", one.contains("reason") ? one["reason"].get<std::string>().c_str()
                                                : one["title"].get<std::string>().c_str());
}

void run_anthropometry(const FaceSettings& settings) {
    const Session session(settings.common.num_threads);
    const KnownFace face = read_known_face(session, settings.mesh, settings.fit_json, settings.sd);
    warn_of_unit(session, {face.mesh, settings.mesh});
    const Landmarks landmarks = landmarks_of(session, settings);
    std::optional<Norms> norms;
    if (!settings.norms.empty()) norms.emplace(session, settings.norms);
    AnthropometryOptions options;
    options.place_sd_mm = face.place_sd_mm;
    options.normal_sd_mm = face.sd_mm;
    options.norms = norms ? &*norms : nullptr;
    const Anthropometry result(session, face.mesh, landmarks, options);
    nlohmann::json report = nlohmann::json::parse(result.json());
    std::printf("%-22s %9s %8s %-8s%s\n", "measurement", "value", "sd", "unit",
                norms ? "       z            " : "");
    for (const nlohmann::json& one : report["anthropometry"]["measurements"])
        if (settings.all || !one.contains("reason")) print_measurement(one, norms.has_value());
    std::printf("%zu of %zu measurements have their landmarks\n", result.known_count(),
                result.size());
    if (face.place_sd_mm.empty()) std::puts("no deviation: the places' errors are unknown");
    report["mesh"] = settings.mesh;
    write_report(settings.common, report);
}

void run_norms(const FaceSettings& settings) {
    const Session session(settings.common.num_threads);
    const Norms norms(session, settings.data, landmarks_of(session, settings), progress_bar());
    norms.save(session, settings.out);
    const nlohmann::json file = nlohmann::json::parse(norms.json());
    std::printf("%zu norms\n", file["norms"].size());
    write_report(settings.common, file);
}

void draw(const FaceSettings& settings, const Mesh& mesh, const std::vector<double>& field) {
    RenderOptions options;
    options.scalar = field;
    options.color_map = ColorMap::diverging;
    options.label = "side minus the other's reflection, mm";
    write_png(settings.picture, render_mesh(arrays_of(mesh), options));
}

void print_plane(const mien_mirror_plane& plane) {
    constexpr double kDegrees = 57.29577951308232;
    std::printf("mirror plane by %s: tilt sd %.2f degrees, offset sd %.2f mm, sides %.2f mm apart",
                plane.by == MIEN_MIRROR_BY_SURFACE ? "the surface" : "landmarks",
                kDegrees * plane.tilt_sd_rad, plane.offset_sd_mm, plane.rms_mm);
    if (std::isfinite(plane.between_rad))
        std::printf("; by %s it lies %.2f degrees and %.2f mm off",
                    plane.by == MIEN_MIRROR_BY_SURFACE ? "landmarks" : "the surface",
                    kDegrees * plane.between_rad, std::fabs(plane.apart_mm));
    std::printf("\n");
}

void print_comparisons(const nlohmann::json& report) {
    std::printf("%-16s %9s %9s   mL    %9s %9s   mm\n", "zone, left", "signed", "absolute",
                "signed", "rms");
    const auto row = [](const nlohmann::json& volume, const nlohmann::json& distance) {
        std::printf("%-16.16s %9.3f %9.3f         %9.3f %9.3f",
                    volume["name"].get<std::string>().c_str(), volume["signed_ml"].get<double>(),
                    volume["absolute_ml"].get<double>(), distance["mean_signed_mm"].get<double>(),
                    distance["rms_mm"].get<double>());
        if (volume["low95_ml"].is_number())
            std::printf("   %8.3f .. %8.3f mL", volume["low95_ml"].get<double>(),
                        volume["high95_ml"].get<double>());
        std::printf("\n");
    };
    const nlohmann::json &volume = report["volume"], &distance = report["distance"];
    for (std::size_t z = 0; z < volume["zones"].size(); ++z)
        row(volume["zones"][z], distance["zones"][z]);
    row(volume["whole"], distance["whole"]);
}

void run_asymmetry(const FaceSettings& settings) {
    const Session session(settings.common.num_threads);
    const KnownFace face = read_known_face(session, settings.mesh, settings.fit_json, settings.sd);
    warn_of_unit(session, {face.mesh, settings.mesh});
    const Model model(session, settings.model);
    const Landmarks landmarks = landmarks_of(session, settings);
    AsymmetrySettings options;
    options.zones = measure_zones(settings.zones);
    options.normal_sd_mm = face.sd_mm;
    options.plane =
        settings.plane == "landmarks" ? MIEN_MIRROR_BY_LANDMARKS : MIEN_MIRROR_BY_SURFACE;
    if (landmarks.picked_count() != 0) options.landmarks = &landmarks;
    options.progress = progress_bar();
    const Asymmetry result(session, face.mesh, model.mesh(), options);
    nlohmann::json report = nlohmann::json::parse(result.measurement().json());
    print_plane(result.plane());
    print_comparisons(report);
    if (face.sd_mm.empty()) std::puts("no interval: the surface's errors are unknown");
    const std::vector<double> field = result.measurement().field(MIEN_FIELD_SIGNED_DISTANCE_MM);
    if (!settings.field_path.empty()) write_field(settings.field_path, field);
    if (!settings.picture.empty()) draw(settings, face.mesh, field);
    report["mesh"] = settings.mesh;
    write_report(settings.common, report);
}

using SharedFaceSettings = std::shared_ptr<FaceSettings>;

void add_face(CLI::App& command, const SharedFaceSettings& settings) {
    command.add_option("mesh", settings->mesh, "fitted face, or a record of a fit")
        ->required()
        ->check(CLI::ExistingFile);
    command
        .add_option("--fit-json", settings->fit_json,
                    "what mien register --json wrote beside it: its errors")
        ->check(CLI::ExistingFile);
    command.add_option("--sd", settings->sd, "of every vertex instead, mm")
        ->check(CLI::NonNegativeNumber);
    command.add_option("--landmarks", settings->landmarks, "landmark file; default the model's")
        ->check(CLI::ExistingFile);
}

}  // namespace

void add_anthropometry_commands(CLI::App& measure) {
    const auto settings = std::make_shared<FaceSettings>();
    CLI::App* list = measure.add_subcommand(
        "anthropometry", "lengths, angles and proportions between named landmarks");
    add_face(*list, settings);
    list->add_option("--model", settings->model, "model with the landmarks")
        ->check(CLI::ExistingFile);
    list->add_option("--norms", settings->norms, "norms (mien measure norms): adds z-scores")
        ->check(CLI::ExistingFile);
    list->add_flag("--all", settings->all, "also list what lacks its landmarks, and why");
    add_common_options(*list, settings->common);
    list->footer(
        "Example: mien measure anthropometry fitted.ply --fit-json fit.json --model "
        "face.safetensors --json a.json");
    list->callback([settings] { run_anthropometry(*settings); });

    CLI::App* norms = measure.add_subcommand(
        "norms", "mean and deviation of each measurement over a dataset's people");
    norms->add_option("--data", settings->data, "dataset with neutral faces of ten people or more")
        ->required()
        ->check(CLI::ExistingFile);
    norms->add_option("--landmarks", settings->landmarks, "landmark file; default the model's")
        ->check(CLI::ExistingFile);
    norms->add_option("--model", settings->model, "model with the landmarks")
        ->check(CLI::ExistingFile);
    norms->add_option("--out", settings->out, "norms file, JSON")->required();
    add_common_options(*norms, settings->common);
    norms->footer(
        "Example: mien measure norms --data people.safetensors --model face.safetensors "
        "--out norms.json");
    norms->callback([settings] { run_norms(*settings); });

    CLI::App* sides = measure.add_subcommand("asymmetry", "the left side against the right");
    add_face(*sides, settings);
    sides->add_option("--model", settings->model, "model whose template is symmetric about x = 0")
        ->required()
        ->check(CLI::ExistingFile);
    sides->add_option("--zones", settings->zones, "zone file")->check(CLI::ExistingFile);
    sides->add_option("--plane", settings->plane, "what the mirror plane is found by")
        ->check(CLI::IsMember({"surface", "landmarks"}))
        ->capture_default_str();
    sides->add_option("--field", settings->field_path, "write the signed distance of each vertex");
    sides->add_option("--picture", settings->picture, "draw it (.png)");
    add_common_options(*sides, settings->common);
    sides->footer(
        "Example: mien measure asymmetry fitted.ply --fit-json fit.json --model "
        "face.safetensors --zones zones.json --picture sides.png");
    sides->callback([settings] { run_asymmetry(*settings); });
}

}  // namespace mien::cli
