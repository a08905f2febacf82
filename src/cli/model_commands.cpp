// mien model build|info|sample|tune (fit, synthesize, condition: coefficient_commands.cpp): how a
// template may move, computed once and kept in a file.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>

#include "commands.hpp"
#include "fields.hpp"
#include "plot.hpp"

namespace mien::cli {
namespace {

const std::map<std::string, std::int32_t>& kernels() {
    static const std::map<std::string, std::int32_t> names{
        {"geodesic-se", MIEN_KERNEL_GEODESIC_SE},
        {"euclidean-se", MIEN_KERNEL_EUCLIDEAN_SE},
        {"bspline", MIEN_KERNEL_BSPLINE},
        {"surface-matern", MIEN_KERNEL_SURFACE_MATERN},
        {"none", MIEN_KERNEL_NONE}};
    return names;
}

const std::map<std::string, std::int32_t>& boundaries() {
    static const std::map<std::string, std::int32_t> names{{"neumann", MIEN_HEAT_NEUMANN},
                                                           {"dirichlet", MIEN_HEAT_DIRICHLET},
                                                           {"average", MIEN_HEAT_AVERAGE}};
    return names;
}

template <typename Names>
std::vector<std::string> keys(const Names& names) {
    std::vector<std::string> list;
    list.reserve(names.size());
    for (const auto& entry : names) list.push_back(entry.first);
    return list;
}

/// "geodesic-se:40:0.5": one more kernel of a sum.
mien_kernel parse_kernel(const std::string& text) {
    const std::size_t first = text.find(':'), second = text.find(':', first + 1);
    const auto kind = kernels().find(text.substr(0, first));
    mien_kernel kernel{0, 0, 0.0, 1.0, 2.0};
    try {
        if (kind == kernels().end() || kind->second == MIEN_KERNEL_NONE ||
            first == std::string::npos)
            throw std::invalid_argument("");
        kernel.kind = kind->second;
        kernel.sigma_mm = std::stod(text.substr(first + 1, second - first - 1));
        if (second != std::string::npos) kernel.scale_mm = std::stod(text.substr(second + 1));
    } catch (const std::exception&) {
        throw std::runtime_error("--add-kernel " + text +
                                 ": expected KERNEL:SIGMA[:SCALE], for example "
                                 "geodesic-se:40:0.5");
    }
    return kernel;
}

struct BuildSettings {
    Common common;
    std::string template_path, kernel = "geodesic-se", boundary = "neumann", landmarks, zones,
                               scales, out, check_picture;
    bool accept_faults = false;
    std::vector<std::string> more_kernels;
    ModelSettings model;
};

/// One number per line, as `mien measure --field` writes them.
std::vector<double> read_values(const std::string& path) {
    const nlohmann::json file = read_json(path);
    if (!file.is_array())
        throw std::runtime_error(path + ": expected a list of one number per vertex");
    return file.get<std::vector<double>>();
}

void print_info(const nlohmann::json& info) {
    const auto text = [&](const char* key) {
        const auto found = info["info"].find(key);
        if (found == info["info"].end()) return std::string("-");
        return found->is_string() ? found->template get<std::string>() : found->dump();
    };
    std::printf("kernel              %s, sigma %s mm, scale %s mm\n", text("kernel").c_str(),
                text("sigma_mm").c_str(), text("scale_mm").c_str());
    std::printf("template            %d vertices, %d triangles, %zu landmarks, %zu zones\n",
                info["vertices"].get<int>(), info["triangles"].get<int>(), info["landmarks"].size(),
                info["zones"].size());
    std::printf("modes               %d deformation modes (%d scalar), %d trained on faces\n",
                info["deformation_modes"].get<int>(), info["scalar_modes"].get<int>(),
                info["pca_modes"].get<int>());
    if (const auto left = info["info"].find("pca_left_out_mm"); left != info["info"].end())
        std::printf("people left out     %.2f mm per axis are beyond what the trained modes span\n",
                    left->get<double>());
    std::printf("variance explained  %s\n", text("variance_explained").c_str());
    std::printf("largest error       %s of the variance at one vertex\n",
                text("max_variance_error").c_str());
    std::printf("clipped             %s of the spectral mass, %s negative eigenvalues\n",
                text("negative_mass").c_str(), text("negative_eigenvalues").c_str());
}

void run_build(BuildSettings& settings) {
    const Session session(settings.common.num_threads);
    const Mesh mesh(session, settings.template_path);
    const nlohmann::json findings =
        print_template_check(session, mesh, settings.template_path, settings.landmarks,
                             settings.model.mirror_symmetric, settings.check_picture);
    if (findings["errors"] != 0 && !settings.accept_faults)
        throw std::runtime_error(settings.template_path +
                                 ": is no good template (see above); mend it, or give "
                                 "--accept-faults");
    ModelSettings& model = settings.model;
    model.kernel = kernels().at(settings.kernel);
    model.heat_boundary = boundaries().at(settings.boundary);
    for (const std::string& text : settings.more_kernels)
        model.more_kernels.push_back(parse_kernel(text));
    if (!settings.landmarks.empty())
        for (auto& [name, vertex] : read_landmark_vertices(settings.landmarks))
            model.landmarks.push_back({name, vertex});
    if (!settings.zones.empty()) model.zones = Zones(session, settings.zones).all();
    if (!settings.scales.empty()) model.scale_per_vertex = read_values(settings.scales);
    model.progress = progress_bar();
    const Model built = Model::build(session, mesh, model);
    built.save(session, settings.out);
    const nlohmann::json info = nlohmann::json::parse(built.json());
    if (model.kernel != MIEN_KERNEL_NONE && info["deformation_modes"].get<int>() < model.num_modes)
        std::printf("note: %d of %d modes; %s\n", info["deformation_modes"].get<int>(),
                    model.num_modes,
                    model.num_modes % 3 != 0 ? "three deformation modes make one scalar mode"
                                             : "the kernel has no more variance to give");
    print_info(info);
    write_report(settings.common, info);
}

void add_build(CLI::App& parent) {
    auto settings = std::make_shared<BuildSettings>();
    CLI::App& command =
        *parent.add_subcommand("build", "build a deformation model from a template");
    ModelSettings& model = settings->model;
    command.add_option("--template", settings->template_path, "template mesh")->required();
    command.add_option("--kernel", settings->kernel, "what makes two vertices move alike")
        ->check(CLI::IsMember(keys(kernels())))
        ->capture_default_str();
    command.add_option("--sigma", model.sigma_mm, "length scale of the kernel, mm")
        ->capture_default_str();
    command.add_option("--scale", model.scale_mm, "deviation of a displacement's coordinate, mm")
        ->capture_default_str();
    command.add_option("--nu", model.nu, "smoothness of surface-matern")->capture_default_str();
    command
        .add_option("--levels", model.levels, "sum of kernels with sigma, 2 sigma, 4 sigma, ...")
        ->capture_default_str();
    command.add_option("--add-kernel", settings->more_kernels,
                       "another summand: KERNEL:SIGMA[:SCALE]");
    command
        .add_option("--modes", model.num_modes, "deformation modes at most, three per scalar mode")
        ->capture_default_str();
    command
        .add_option("--tolerance", model.tolerance, "stop once this share of the variance is left")
        ->capture_default_str();
    command
        .add_option("--control-points", model.num_control_points,
                    "0: as many as modes, at least 1000")
        ->capture_default_str();
    auto* mirror = command.add_flag("--mirror", model.mirror_symmetric,
                                    "modes even or odd about the plane x = 0");
    command
        .add_option("--mirror-correlation", model.mirror_correlation,
                    "how much both sides are expected to move alike, 0 to 1 (with --mirror)")
        ->needs(mirror)
        ->capture_default_str();
    command.add_option("--scale-per-vertex", settings->scales,
                       "JSON list of one factor per vertex");
    command.add_option("--boundary", settings->boundary, "heat at borders of the template")
        ->check(CLI::IsMember(keys(boundaries())))
        ->capture_default_str();
    command.add_option("--landmarks", settings->landmarks,
                       "landmark vertices of the template, JSON or CSV");
    command.add_option("--zones", settings->zones,
                       "zones of the template, JSON {\"zones\": {name: [vertex, ...]}}, perhaps "
                       "with further lists beside them, such as \"lips\"");
    auto* pca = command.add_option("--pca", model.pca_dataset,
                                   "dataset of registered faces: adds their mean and modes");
    command.add_option("--pca-modes", model.pca_modes, "0: as many as --pca-variance asks for")
        ->needs(pca)
        ->capture_default_str();
    command.add_option("--pca-variance", model.pca_variance, "share of the faces' variance kept")
        ->needs(pca)
        ->capture_default_str();
    command
        .add_flag("--pca-all,!--pca-neutral", model.pca_all_expressions,
                  "all faces (the default), or the neutral ones alone")
        ->needs(pca);
    command
        .add_flag("--pca-align", model.pca_align, "move each face rigidly onto the template first")
        ->needs(pca);
    command.add_option("--check-picture", settings->check_picture,
                       "PNG of the template with the places that its check complains of");
    command.add_flag("--accept-faults", settings->accept_faults,
                     "build although the template's check finds errors");
    command.add_option("--out", settings->out, "model file to write")->required();
    add_common_options(command, settings->common, true);
    command.footer(
        "Example: mien model build --template face.ply --kernel geodesic-se --sigma 20 --modes 999 "
        "--out face.safetensors");
    command.callback([settings] { run_build(*settings); });
}

struct InfoSettings {
    Common common;
    std::string path;
};

void add_info(CLI::App& parent) {
    auto settings = std::make_shared<InfoSettings>();
    CLI::App& command = *parent.add_subcommand("info", "say what a model file holds");
    command.add_option("model", settings->path, "model file")->required();
    add_common_options(command, settings->common);
    command.footer("Example: mien model info face.safetensors");
    command.callback([settings] {
        const Session session(settings->common.num_threads);
        const nlohmann::json info = nlohmann::json::parse(Model(session, settings->path).json());
        print_info(info);
        write_report(settings->common, info);
    });
}

struct SampleSettings {
    Common common;
    std::string path, out_dir, format = "ply", picture;
    int count = 1, mode = -1;
    double strength = 1, sigma = 1;
};

/// One coefficient at `sigma` and all others at zero: the mean with one eigenfunction (figure 2.10
/// of the thesis), as a mesh and as a picture of the displacement of a deviation.
void run_mode(const SampleSettings& settings) {
    const Session session(settings.common.num_threads);
    const Model model(session, settings.path);
    const std::size_t scalar = 3 * model.scalar_modes(), all = scalar + model.vector_modes();
    const auto mode = static_cast<std::size_t>(settings.mode);
    if (mode >= all)
        throw CLI::ValidationError("--mode",
                                   "the model has the modes 0 to " + std::to_string(all - 1));
    std::vector<double> coefficients(mode < scalar ? mode - mode % 3 + 3 : mode + 1, 0.0);
    coefficients[mode] = settings.sigma;
    std::filesystem::create_directories(std::filesystem::u8path(settings.out_dir));
    char name[40];
    std::snprintf(name, sizeof name, "mode_%04d.", settings.mode);
    const std::string path = settings.out_dir + "/" + name + settings.format;
    synthesize(session, model, coefficients).save(session, path);
    // The eigenfunction itself: along its axis with a sign, of trained modes the length.
    const auto mean = synthesize(session, model, {}).positions();
    coefficients[mode] = 1;
    const auto moved = synthesize(session, model, coefficients).positions();
    std::vector<double> field(mean.size());
    for (std::size_t v = 0; v < mean.size(); ++v) {
        const Position d{moved[v][0] - mean[v][0], moved[v][1] - mean[v][1],
                         moved[v][2] - mean[v][2]};
        field[v] = mode < scalar ? d[mode % 3] : std::hypot(std::hypot(d[0], d[1]), d[2]);
    }
    const FieldSummary summary = summary_of(field);
    const std::string what = mode < scalar ? std::string("scalar mode ") +
                                                 std::to_string(mode / 3) + ", " + "xyz"[mode % 3]
                                           : "trained mode " + std::to_string(mode - scalar);
    std::printf("%s: %.4g to %.4g mm per deviation\n", what.c_str(), summary.least, summary.most);
    FieldPicture picture{
        "mm per deviation", what, mode < scalar, mode < scalar ? std::nan("") : 0.0, {}};
    draw_field(settings.picture, model.mesh(), field, picture);
    write_report(settings.common, {{"mode", settings.mode},
                                   {"sigma", settings.sigma},
                                   {"eigenfunction_mm", summary_json(summary)},
                                   {"files", {path}}});
}

void run_sample(const SampleSettings& settings) {
    if (settings.mode >= 0) return run_mode(settings);
    const Session session(settings.common.num_threads);
    const Model model = Model(session, settings.path);
    std::filesystem::create_directories(std::filesystem::u8path(settings.out_dir));
    nlohmann::json files = nlohmann::json::array();
    for (int k = 0; k < settings.count; ++k) {
        char name[40];
        std::snprintf(name, sizeof name, "sample_%03d.", k);
        const std::string path = settings.out_dir + "/" + name + settings.format;
        model
            .sample(session, settings.common.seed, static_cast<std::uint64_t>(k), settings.strength)
            .save(session, path);
        files.push_back(path);
    }
    std::printf("%d faces in %s\n", settings.count, settings.out_dir.c_str());
    write_report(
        settings.common,
        {{"seed", settings.common.seed}, {"strength", settings.strength}, {"files", files}});
}

void add_sample(CLI::App& parent) {
    auto settings = std::make_shared<SampleSettings>();
    CLI::App& command = *parent.add_subcommand("sample", "write random faces of a model");
    command.add_option("model", settings->path, "model file")->required();
    command.add_option("--count", settings->count, "faces")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command
        .add_option("--strength", settings->strength,
                    "in units of the prior's deviation; 0: the mean")
        ->capture_default_str();
    auto* mode = command
                     .add_option("--mode", settings->mode,
                                 "one mode instead of chance: x, y and z of each scalar mode, then "
                                 "the trained ones, from 0")
                     ->check(CLI::NonNegativeNumber);
    command.add_option("--sigma", settings->sigma, "with --mode: in units of its deviation")
        ->needs(mode)
        ->capture_default_str();
    command.add_option("--picture", settings->picture, "with --mode: PNG of the eigenfunction")
        ->needs(mode);
    command.add_option("--format", settings->format, "of the mesh files")
        ->check(CLI::IsMember({"ply", "obj", "stl", "off"}))
        ->capture_default_str();
    command.add_option("--out-dir", settings->out_dir, "folder for sample_000.ply, ...")
        ->required();
    add_common_options(command, settings->common, true);
    command.footer(
        "Example: mien model sample face.safetensors --count 5 --seed 1 --out-dir samples\n"
        "         mien model sample face.safetensors --mode 2 --sigma 3 --picture mode.png "
        "--out-dir "
        "samples");
    command.callback([settings] { run_sample(*settings); });
}

struct TuneCommand {
    Common common;
    std::string template_path, targets, kernel = "geodesic-se", sigmas, scales = "1", levels = "1",
                                        plot;
    TuneSettings tune;
};

/// "A:B:STEP" with both ends, or "A,B,C".
std::vector<double> parse_range(const std::string& option, const std::string& text) {
    std::vector<double> values;
    const bool range = text.find(':') != std::string::npos;
    try {
        for (std::size_t at = 0; at <= text.size();) {
            const std::size_t end = std::min(text.find(range ? ':' : ',', at), text.size());
            values.push_back(std::stod(text.substr(at, end - at)));
            at = end + 1;
        }
        if (range) {
            if (values.size() != 3 || !(values[2] > 0) || !(values[1] >= values[0]) ||
                (values[1] - values[0]) / values[2] > 9999)
                throw std::invalid_argument("");
            const double first = values[0], last = values[1], step = values[2];
            values.clear();
            for (int k = 0; first + k * step <= last + 1e-9 * step; ++k)
                values.push_back(first + k * step);
        }
    } catch (const std::exception&) {
        throw std::runtime_error(option + " " + text + ": expected A:B:STEP or a list A,B,C of " +
                                 (option == "--levels" ? "numbers of levels" : "millimetres"));
    }
    return values;
}

void run_tune(TuneCommand& settings) {
    const Session session(settings.common.num_threads);
    const Mesh mesh(session, settings.template_path);
    settings.tune.kernel = kernels().at(settings.kernel);
    settings.tune.sigmas_mm = parse_range("--sigma", settings.sigmas);
    settings.tune.scales_mm = parse_range("--scale", settings.scales);
    settings.tune.scale_mm = settings.tune.scales_mm.front();
    for (const double levels : parse_range("--levels", settings.levels)) {
        if (levels != std::floor(levels))
            throw std::runtime_error("--levels " + settings.levels + ": levels are whole numbers");
        settings.tune.level_counts.push_back(static_cast<std::int32_t>(levels));
    }
    settings.tune.levels = settings.tune.level_counts.front();
    settings.tune.progress = progress_bar();
    const nlohmann::json report =
        nlohmann::json::parse(tune_kernel(session, mesh, settings.targets, settings.tune));
    const bool grid = settings.tune.scales_mm.size() * settings.tune.level_counts.size() > 1;
    std::printf(grid ? "%10s %10s %8s %12s %10s" : "%10s %.0s%.0s%12s %10s", "sigma", "scale",
                "levels", "mean", "sd");
    std::printf("   (residual norm, mm, over %d faces)\n", report["faces"].get<int>());
    std::vector<Curve> curves;
    for (const nlohmann::json& point : report["points"]) {
        const double sigma = point["sigma_mm"], scale = point["scale_mm"];
        const int levels = point["levels"];
        // One curve per scale and levels, over sigma: figure 2.9 of the thesis.
        const std::string label =
            !grid ? settings.kernel
                  : std::to_string(levels) + " levels, scale " + short_number(scale);
        if (curves.empty() || curves.back().label != label) {
            curves.emplace_back();
            curves.back().label = label;
            curves.back().markers = true;
        }
        curves.back().x.push_back(sigma);
        curves.back().y.push_back(point["residual_mean_mm"]);
        if (!grid) curves.back().error.push_back(point["residual_sd_mm"]);
        std::printf("%10g ", sigma);
        if (grid) std::printf("%10g %8d ", scale, levels);
        const bool best = sigma == report["best_sigma_mm"].get<double>() &&
                          scale == report["best_scale_mm"].get<double>() &&
                          levels == report["best_levels"].get<int>();
        std::printf("%12.3f %10.3f%s\n", point["residual_mean_mm"].get<double>(),
                    point["residual_sd_mm"].get<double>(), best ? "   best" : "");
    }
    if (!settings.plot.empty()) {
        PlotOptions options;
        options.title = "fit with known correspondence, " + settings.kernel;
        options.x_label = "sigma, mm";
        options.y_label = "residual norm, mm";
        options.zero_y = true;
        write_png(settings.plot, draw_plot(curves, options));
    }
    write_report(settings.common, report);
}

void add_tune(CLI::App& parent) {
    auto settings = std::make_shared<TuneCommand>();
    CLI::App& command =
        *parent.add_subcommand("tune", "residual against the kernel's length scale");
    command.add_option("--template", settings->template_path, "template mesh")->required();
    command
        .add_option("--targets", settings->targets,
                    "dataset of faces in the template's correspondence")
        ->required();
    command.add_option("--kernel", settings->kernel, "what makes two vertices move alike")
        ->check(CLI::IsMember({"geodesic-se", "euclidean-se", "bspline", "surface-matern"}))
        ->capture_default_str();
    command.add_option("--sigma", settings->sigmas, "A:B:STEP or A,B,C, mm")->required();
    command
        .add_option("--scale", settings->scales,
                    "deviation of a displacement's coordinate, mm; several as for --sigma")
        ->capture_default_str();
    command.add_option("--nu", settings->tune.nu, "smoothness of surface-matern")
        ->capture_default_str();
    command
        .add_option("--levels", settings->levels,
                    "sum of sigma, 2 sigma, 4 sigma, ...; several as for --sigma")
        ->capture_default_str();
    command.add_option("--modes", settings->tune.num_modes, "deformation modes")
        ->capture_default_str();
    command.add_option("--rho", settings->tune.rho, "weight of the prior in the fits")
        ->capture_default_str();
    command.add_option("--expressions", settings->tune.expressions, "these faces only")
        ->delimiter(',');
    command.add_option("--subjects", settings->tune.max_subjects, "the first N subjects only")
        ->capture_default_str();
    command.add_option("--plot", settings->plot, "picture of residual against sigma, PNG");
    add_common_options(command, settings->common);
    command.footer(
        "Example: mien model tune --template face.ply --targets faces.safetensors --kernel "
        "geodesic-se "
        "--sigma 10:40:5 --expressions neutral,mouth_stretch --subjects 1 --json tune.json\n"
        "         mien model tune --template face.ply --targets faces.safetensors --sigma 10:40:10 "
        "--scale 1,3 --levels 1,4 --plot tune.png");
    command.callback([settings] { run_tune(*settings); });
}

}  // namespace

void add_model_commands(CLI::App& app) {
    CLI::App& model = *app.add_subcommand("model", "deformation models: how a template may move");
    model.require_subcommand(1);
    add_build(model);
    add_template_check(model);
    add_info(model);
    add_sample(model);
    add_coefficient_commands(model);
    add_tune(model);
}

}  // namespace mien::cli
