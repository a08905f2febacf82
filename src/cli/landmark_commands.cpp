// Landmark files: `mien landmarks convert`, and what other commands read of them.
#include <cstdio>

#include "commands.hpp"

namespace mien::cli {
namespace {

struct ConvertArguments {
    std::string in, out, model, mesh;
    Common common;
};

std::string joined(const nlohmann::json& names, std::size_t most) {
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < most; ++i)
        text += (i > 0 ? ", " : "") + names[i].get<std::string>();
    return names.size() > most ? text + ", ..." : text;
}

void run_convert(const ConvertArguments& arguments) {
    const Session session(arguments.common.num_threads);
    Landmarks landmarks(session, arguments.in);
    const nlohmann::json read = nlohmann::json::parse(landmarks.json());
    if (!arguments.model.empty()) {
        landmarks = landmarks.match(Model(session, arguments.model));
        warn_of_unknown_landmarks(landmarks, arguments.in);
    }
    if (!arguments.mesh.empty()) landmarks = landmarks.on(Mesh(session, arguments.mesh));
    landmarks.save(session, arguments.out);
    nlohmann::json report = nlohmann::json::parse(landmarks.json());
    for (const char* key : {"format", "system", "unit_to_mm"}) report[key] = read[key];
    report["out"] = arguments.out;
    write_report(arguments.common, report);
    std::string line =
        std::to_string(landmarks.size()) + " landmarks of " + read["format"].get<std::string>();
    const std::string system = read["system"];
    if (!system.empty()) line += ", " + system + " brought to LPS";
    if (!report["not_picked"].empty()) line += "; not picked: " + joined(report["not_picked"], 10);
    std::puts(line.c_str());
}

}  // namespace

std::string warn_of_unknown_landmarks(const Landmarks& matched, const std::string& path) {
    constexpr std::size_t kNamed = 5;
    const nlohmann::json report = nlohmann::json::parse(matched.json());
    const nlohmann::json& unknown = report["unknown"];
    // Of MediaPipe's 468 points most have no counterpart: that is no mistake of the file.
    if (unknown.empty() || report["scheme"] == "MediaPipe") return "";
    std::string text =
        std::to_string(unknown.size()) +
        " landmarks are unknown to the model and left out: " + joined(unknown, kNamed);
    std::fprintf(stderr, "mien: warning: %s: %s\n", path.c_str(), text.c_str());
    return text;
}

std::vector<NamedPoint> picked_points(const Landmarks& landmarks, const std::string& path) {
    std::vector<NamedPoint> points;
    for (const LandmarkMark& mark : landmarks.all()) {
        if (mark.where == MIEN_MARK_VERTEX)
            throw std::runtime_error(path + ": landmark '" + mark.name +
                                     "' is a vertex number, here places are needed; `mien "
                                     "landmarks convert --mesh MESH` makes them");
        if (mark.where == MIEN_MARK_PLACE) points.push_back({mark.name, mark.position});
    }
    return points;
}

std::vector<NamedPoint> read_landmark_points(const std::string& path) {
    return picked_points(Landmarks(Session(), path), path);
}

std::vector<std::pair<std::string, std::uint32_t>> read_landmark_vertices(const std::string& path) {
    std::vector<std::pair<std::string, std::uint32_t>> vertices;
    for (const LandmarkMark& mark : Landmarks(Session(), path).all()) {
        if (mark.where == MIEN_MARK_PLACE)
            throw std::runtime_error(path + ": landmark '" + mark.name +
                                     "' is a place; here vertex numbers of the template are "
                                     "needed: {\"vertices\": {name: vertex}}");
        if (mark.where == MIEN_MARK_VERTEX) vertices.emplace_back(mark.name, mark.vertex);
    }
    return vertices;
}

void add_landmark_commands(CLI::App& app) {
    CLI::App& landmarks = *app.add_subcommand("landmarks", "files of landmarks");
    landmarks.require_subcommand(1);
    auto arguments = std::make_shared<ConvertArguments>();
    CLI::App& convert =
        *landmarks.add_subcommand("convert", "write a landmark file as another kind");
    convert
        .add_option("in", arguments->in,
                    "JSON, .mrk.json or .fcsv of 3D Slicer, .pp of MeshLab, .pts, .ljson, a table "
                    "name,x,y,z or name,vertex, or vertex numbers")
        ->required();
    convert
        .add_option("out", arguments->out,
                    ".json, .mrk.json, .fcsv, .pp, .pts, .ljson or .csv; Slicer's are LPS")
        ->required();
    convert.add_option("--model", arguments->model,
                       "rename them as this model does (numbers of iBUG-68 and MediaPipe too)");
    convert.add_option("--mesh", arguments->mesh, "make places of vertex numbers of this mesh");
    add_common_options(convert, arguments->common);
    convert.footer(
        "Example: mien landmarks convert scan.mrk.json scan.json --model "
        "face.safetensors");
    convert.callback([arguments] { run_convert(*arguments); });
}

}  // namespace mien::cli
