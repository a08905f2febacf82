// mien expression sample|synthesize|transfer: faces made by an expression model.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "commands.hpp"

namespace mien::cli {
namespace {

struct FaceCommand {
    Common common;
    std::string model, expression, out, out_dir, coordinates, source, target;
    std::vector<double> identity, expression_coordinates;
    int count = 1;
    std::string format = "ply";
};
using SharedFace = std::shared_ptr<FaceCommand>;

CLI::App& add_face_command(CLI::App& group, const char* name, const char* text, const char* example,
                           const SharedFace& o, void (*run)(const FaceCommand&),
                           bool with_seed = false) {
    CLI::App& command = *group.add_subcommand(name, text);
    command.add_option("model", o->model, "expression model file")->required();
    add_common_options(command, o->common, with_seed);
    command.footer(std::string("Example: ") + example);
    command.callback([o, run] { run(*o); });
    return command;
}

void run_sample(const FaceCommand& o) {
    const Session session(o.common.num_threads);
    const ExpressionModel model(session, o.model);
    std::filesystem::create_directories(std::filesystem::u8path(o.out_dir));
    nlohmann::json files = nlohmann::json::array();
    for (int k = 0; k < o.count; ++k) {
        char name[40];
        std::snprintf(name, sizeof name, "face_%03d.", k);
        const std::string path = o.out_dir + "/" + name + o.format;
        model
            .sample(session, o.common.seed + static_cast<std::uint64_t>(k),
                    o.expression.empty() ? nullptr : o.expression.c_str())
            .save(session, path);
        files.push_back(path);
    }
    std::printf("%d faces in %s\n", o.count, o.out_dir.c_str());
    write_report(o.common,
                 {{"seed", o.common.seed}, {"expression", o.expression}, {"files", files}});
}

/// The coordinates of a report of `mien neutralize --json`, or a plain list under the key.
std::vector<double> coordinates_of(const nlohmann::json& file, const std::string& path,
                                   const char* key) {
    const std::string alternative = std::string(key) + "_coordinates_mm";
    const auto found = file.contains(alternative) ? file.find(alternative) : file.find(key);
    if (found == file.end()) return {};
    try {
        return found->get<std::vector<double>>();
    } catch (const nlohmann::json::exception&) {
        throw std::runtime_error(path + ": '" + key + "' is no list of numbers");
    }
}

void run_synthesize(const FaceCommand& o) {
    const Session session(o.common.num_threads);
    const ExpressionModel model(session, o.model);
    std::vector<double> identity = o.identity, expression = o.expression_coordinates;
    if (!o.coordinates.empty()) {
        const nlohmann::json file = read_json(o.coordinates);
        if (!file.is_object())
            throw std::runtime_error(o.coordinates +
                                     ": expected {\"identity\": [...], \"expression\": [...]}");
        if (identity.empty()) identity = coordinates_of(file, o.coordinates, "identity");
        if (expression.empty()) expression = coordinates_of(file, o.coordinates, "expression");
    }
    // Fewer than the model's modes: the others are zero.
    const auto fill = [](std::vector<double>& values, std::uint32_t modes, const char* what) {
        if (values.size() > modes)
            throw std::runtime_error(std::to_string(values.size()) + " " + what +
                                     " coordinates, the model has " + std::to_string(modes));
        if (!values.empty()) values.resize(modes, 0.0);
    };
    fill(identity, model.identity_modes(), "identity");
    fill(expression, model.expression_modes(), "expression");
    model.synthesize(session, identity, expression).save(session, o.out);
    write_report(o.common, {{"identity", identity}, {"expression", expression}, {"out", o.out}});
}

void run_transfer(const FaceCommand& o) {
    const Session session(o.common.num_threads);
    const ExpressionModel model(session, o.model);
    const Neutralization source(session, model, Mesh(session, o.source));
    const Neutralization target(session, model, Mesh(session, o.target));
    source.transfer_to(session, model, target).save(session, o.out);
    write_report(o.common, {{"source", o.source},
                            {"target", o.target},
                            {"expression", source.expression()},
                            {"out", o.out}});
}

}  // namespace

void add_face_commands(CLI::App& app) {
    CLI::App& group = *app.add_subcommand("expression", "faces made by an expression model");
    group.require_subcommand(1);

    auto o = std::make_shared<FaceCommand>();
    CLI::App* command =
        &add_face_command(group, "sample", "random identities, with an expression if asked",
                          "mien expression sample expr.safetensors --expression smile --count 5 "
                          "--seed 1 --out-dir faces",
                          o, &run_sample, true);
    command->add_option("--expression", o->expression,
                        "name of an expression, neutral, or any; without it neutral");
    command->add_option("--count", o->count, "faces; face k has the seed + k")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--format", o->format, "of the mesh files")
        ->check(CLI::IsMember({"ply", "obj", "stl", "off"}))
        ->capture_default_str();
    command->add_option("--out-dir", o->out_dir, "folder for face_000.ply, ...")->required();

    o = std::make_shared<FaceCommand>();
    command = &add_face_command(
        group, "synthesize", "the face of given coordinates",
        "mien expression synthesize expr.safetensors --identity 40,-15 --expression 20 "
        "--out face.ply",
        o, &run_synthesize);
    command->add_option("--identity", o->identity, "first identity coordinates, mm; others are 0")
        ->delimiter(',');
    command
        ->add_option("--expression", o->expression_coordinates,
                     "first expression coordinates, mm; others are 0")
        ->delimiter(',');
    command->add_option("--coordinates", o->coordinates,
                        "JSON {\"identity\": [...], \"expression\": [...]}, or a report of "
                        "mien neutralize");
    command->add_option("--out", o->out, "mesh to write")->required();

    o = std::make_shared<FaceCommand>();
    command = &add_face_command(
        group, "transfer", "one face's expression on another person's face",
        "mien expression transfer expr.safetensors --source a_smile.ply --target b.ply "
        "--out b_smile.ply",
        o, &run_transfer);
    command->add_option("--source", o->source, "fitted face with the expression")->required();
    command->add_option("--target", o->target, "fitted face of the other person, any expression")
        ->required();
    command->add_option("--out", o->out, "mesh to write")->required();
}

}  // namespace mien::cli
