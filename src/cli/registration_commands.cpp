#include "fit_options.hpp"
#include "render.hpp"

namespace mien::cli {
namespace {

struct RegisterArguments {
    std::string model, scan, landmarks, out, heatmap, record, reference, reference_scan;
    FitArguments fit;
    Common common;
};

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

Registration tied_to_reference(const Session& session, const Model& model, const Mesh& scan,
                               const RegisterArguments& arguments, const Registration& fit) {
    const Registration reference(session, arguments.reference);
    const Mesh reference_scan(session, arguments.reference_scan);
    TieOptions options;
    options.progress = progress_bar();
    return fit.tied_to(session, model, reference, reference_scan, scan, options);
}

void run_register(const RegisterArguments& arguments) {
    const Session session(arguments.common.num_threads);
    const Model model(session, arguments.model);
    const Mesh scan(session, arguments.scan);
    RegisterOptions options = register_options(arguments.fit);
    if (arguments.fit.start == "landmarks" && arguments.landmarks.empty())
        throw CLI::ValidationError("--start landmarks", "needs --landmarks");
    nlohmann::json landmarks;
    if (!arguments.landmarks.empty())
        landmarks = add_landmarks(session, model, arguments.landmarks, options);
    options.progress = progress_bar();
    Registration fit(session, model, scan, options);
    // Only what a good enough fit carries can be compared.
    const bool tie = !arguments.reference.empty();
    const bool tied = tie && fit.verdict().quality != MIEN_QUALITY_FAILED;
    if (tied) fit = tied_to_reference(session, model, scan, arguments, fit);
    fit.mesh().save(session, arguments.out);
    nlohmann::json report = fit_report(fit, !arguments.common.json_path.empty());
    report["out"] = arguments.out;
    if (tie && !tied) {
        report["reference"] = {{"tied", false}, {"why_not", "the fit failed"}};
        if (arguments.fit.accept_failed)
            std::fprintf(stderr, "mien: %s: the fit failed, so it is not tied to %s\n",
                         arguments.scan.c_str(), arguments.reference.c_str());
    }
    if (!landmarks.is_null()) report["landmark_file"] = landmarks;
    write_report(arguments.common, report);
    if (!arguments.record.empty()) fit.save(session, arguments.record);
    if (!arguments.heatmap.empty()) write_heatmap(arguments.heatmap, fit);
    std::puts(verdict_line(report).c_str());
    if (report["quality"] == "failed" && !arguments.fit.accept_failed)
        throw std::runtime_error(arguments.scan + ": the fit failed (" + first_reason(report) +
                                 "); its files are written; mend the cause, or give "
                                 "--accept-failed to go on with it");
}

}  // namespace

void add_registration_commands(CLI::App& app) {
    auto* command = app.add_subcommand("register", "fit a model's template to a scan");
    auto arguments = std::make_shared<RegisterArguments>();
    command->add_option("--model", arguments->model, "deformation model")->required();
    command->add_option("--scan", arguments->scan, "mesh file: PLY, OBJ, STL, OFF, GLB, VTP or XYZ")
        ->required();
    auto* landmarks = command->add_option(
        "--landmarks", arguments->landmarks,
        "places on the scan: JSON {\"points\": {name: [x, y, z]}}, .mrk.json, .fcsv, .pp, "
        ".pts, .ljson, .csv");
    add_fit_options(*command, arguments->fit, landmarks);
    command->add_option("--out", arguments->out, "fitted template")->required();
    command->add_option("--record", arguments->record,
                        "keep the fit with its errors as a safetensors file, which report and "
                        "measure volume read in place of a mesh");
    auto* reference = command->add_option("--reference", arguments->reference,
                                          "an earlier visit's fit of the same person, as --record "
                                          "kept it: where both scans' textures "
                                          "show the same skin, the new fit's places slide onto it");
    auto* reference_scan = command->add_option("--reference-scan", arguments->reference_scan,
                                               "the scan that the earlier visit's fit was made of");
    reference->needs(reference_scan);
    reference_scan->needs(reference);
    command->add_option("--heatmap", arguments->heatmap, "PNG of the distance to the scan");
    add_common_options(*command, arguments->common);
    command->footer(
        "Example: mien register --model face.safetensors --scan scan.ply --out fitted.ply --json "
        "fit.json");
    command->callback([arguments] { run_register(*arguments); });
}

}  // namespace mien::cli
