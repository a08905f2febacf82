// `mien model check`, which `mien model build` does first: is a mesh fit to be a template?
#include <cstdio>

#include "commands.hpp"
#include "render.hpp"

namespace mien::cli {
namespace {

struct CheckArguments {
    std::string path, landmarks, picture;
    bool mirror = false;
    Common common;
};

void draw_findings(const std::string& path, const Mesh& mesh, const nlohmann::json& findings) {
    RenderOptions options;
    const MeshArrays arrays = arrays_of(mesh);
    options.views = {"front", "left45", "left", "back"};
    options.title = findings["findings"].empty() ? "nothing found" : "";
    for (const auto& finding : findings["findings"]) {
        options.title += (options.title.empty() ? "" : ", ") + finding["code"].get<std::string>();
        for (const auto& vertex : finding["vertices"])
            options.points.push_back(arrays.positions[vertex.get<std::size_t>()]);
    }
    write_png(path, render_mesh(arrays, options));
}

}  // namespace

nlohmann::json print_template_check(const Session& session, const Mesh& mesh,
                                    const std::string& path, const std::string& landmarks,
                                    bool mirror, const std::string& picture) {
    nlohmann::json findings;
    if (landmarks.empty()) {
        findings = nlohmann::json::parse(check_template(session, mesh, nullptr, mirror));
    } else {
        const Landmarks list(session, landmarks);
        findings = nlohmann::json::parse(check_template(session, mesh, &list, mirror));
    }
    for (const auto& finding : findings["findings"])
        std::printf("%s: %s: %s\n", path.c_str(), finding["kind"].get<std::string>().c_str(),
                    finding["text"].get<std::string>().c_str());
    if (!picture.empty()) draw_findings(picture, mesh, findings);
    return findings;
}

void add_template_check(CLI::App& model) {
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App& command =
        *model.add_subcommand("check", "say whether a mesh is fit to be a template");
    command.add_option("template", arguments->path, "template mesh")->required();
    command.add_option("--landmarks", arguments->landmarks,
                       "its landmark vertices: pose, left and right, eyes and mouth are looked at");
    command.add_flag("--mirror", arguments->mirror, "ask for symmetry about x = 0");
    command.add_option("--picture", arguments->picture, "PNG with the places complained of");
    add_common_options(command, arguments->common);
    command.footer(
        "Example: mien model check face.ply --landmarks landmarks.json --picture "
        "check.png");
    command.callback([arguments] {
        const Session session(arguments->common.num_threads);
        const Mesh mesh(session, arguments->path);
        const nlohmann::json findings =
            print_template_check(session, mesh, arguments->path, arguments->landmarks,
                                 arguments->mirror, arguments->picture);
        write_report(arguments->common, findings);
        if (findings["errors"] != 0)
            throw std::runtime_error(arguments->path + ": is no good template (see above)");
        std::printf("%s: fit to be a template, %d warnings\n", arguments->path.c_str(),
                    findings["warnings"].get<int>());
    });
}

}  // namespace mien::cli
