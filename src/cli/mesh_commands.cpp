// `mien mesh`: look at a mesh, and mend what error messages complain of.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "commands.hpp"
#include "guards.hpp"

namespace mien::cli {
namespace {

using Matrix4 = std::array<double, 16>;

struct MeshArguments {
    std::string in, out, unit, mirror;
    std::vector<double> rotate;
    double factor = 0;
    std::uint64_t min_triangles = 0, vertices = 0;
    double share = 0;
    bool inside_out = false;
    Common common;
};

void print_sizes(const char* what, const Mesh& before, const Mesh& after, const std::string& path) {
    std::printf("%s: %zu vertices and %zu triangles, were %zu and %zu; %s\n", what,
                after.vertex_count(), after.triangles().size(), before.vertex_count(),
                before.triangles().size(), path.c_str());
}

void finish(const Session& session, const MeshArguments& arguments, const char* what,
            const Mesh& before, const Mesh& after) {
    after.save(session, arguments.out);
    print_sizes(what, before, after, arguments.out);
    if (arguments.common.json_path.empty()) return;
    nlohmann::json report = nlohmann::json::parse(inspect_mesh(session, after));
    report["out"] = arguments.out;
    write_report(arguments.common, report);
}

std::string joined(const nlohmann::json& names) {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ", ") + name.get<std::string>();
    return text.empty() ? "none" : text;
}

void run_info(const MeshArguments& arguments) {
    const Session session(arguments.common.num_threads);
    const nlohmann::json r =
        nlohmann::json::parse(inspect_mesh(session, Mesh(session, arguments.in)));
    const auto number = [&](const char* key) { return r[key].get<double>(); };
    const auto whole = [&](const char* key) { return r[key].get<long long>(); };
    std::printf("mesh        %lld vertices, %lld triangles, mean edge %.4g\n", whole("vertices"),
                whole("triangles"), number("mean_edge"));
    std::printf("box         %.4g %.4g %.4g to %.4g %.4g %.4g, extent %.4g\n",
                r["low"][0].get<double>(), r["low"][1].get<double>(), r["low"][2].get<double>(),
                r["high"][0].get<double>(), r["high"][1].get<double>(), r["high"][2].get<double>(),
                number("extent"));
    std::printf("unit        by its size: %s\n", joined(r["plausible_units"]).c_str());
    std::printf("pieces      %lld, the largest of %lld triangles\n", whole("components"),
                whole("largest_component_triangles"));
    std::printf("borders     %lld loops, %lld edges, the longest %.4g\n", whole("border_loops"),
                whole("border_edges"), number("longest_border"));
    std::printf("windings    %lld triangles against the others; faces outwards by %.2f\n",
                whole("turned_triangles"), number("outward"));
    std::printf("edges       %lld of three triangles or more, %lld pinched vertices\n",
                whole("complex_edges"), whole("pinched_vertices"));
    std::printf("colours     %s; %lld texture coordinates\n",
                r["colors"].get<bool>() ? "per vertex" : "none", whole("texture_coordinates"));
    for (const auto& fault : r["faults"])
        std::printf("fault       %s\n", fault.get<std::string>().c_str());
    write_report(arguments.common, r);
}

void run_clean(const MeshArguments& arguments) {
    const Session session(arguments.common.num_threads);
    const Mesh mesh(session, arguments.in);
    finish(session, arguments, "cleaned", mesh, clean_mesh(session, mesh, arguments.min_triangles));
}

void run_convert(const MeshArguments& arguments) {
    const Session session(arguments.common.num_threads);
    const Mesh mesh(session, arguments.in);
    finish(session, arguments, "converted", mesh, mesh);
}

}  // namespace

double unit_in_mm(const std::string& name) {
    static const std::vector<std::pair<std::string, double>> units = {
        {"mm", 1},    {"cm", 10},     {"dm", 100},   {"m", 1000},    {"km", 1e6},
        {"in", 25.4}, {"inch", 25.4}, {"ft", 304.8}, {"foot", 304.8}};
    for (const auto& [known, to_mm] : units)
        if (known == name) return to_mm;
    const std::optional<double> to_mm = plain_number(name);
    if (to_mm && *to_mm > 0) return *to_mm;
    throw std::runtime_error("--units " + name +
                             ": use mm, cm, dm, m, km, in, ft, or the mm that one unit is long");
}

namespace {

void run_scale(const MeshArguments& arguments) {
    double factor = arguments.factor;
    if (!arguments.unit.empty()) factor = unit_in_mm(arguments.unit);
    if (!(factor > 0) || !std::isfinite(factor))
        throw std::runtime_error(
            "give --units, the unit that the file is in, or --factor, a positive number");
    const Session session(arguments.common.num_threads);
    const Mesh mesh(session, arguments.in);
    const Matrix4 matrix{factor, 0, 0, 0, 0, factor, 0, 0, 0, 0, factor, 0, 0, 0, 0, 1};
    finish(session, arguments, "scaled", mesh, transform_mesh(session, mesh, matrix));
}

Matrix4 product(const Matrix4& a, const Matrix4& b) {
    Matrix4 c{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k) c[4 * i + j] += a[4 * i + k] * b[4 * k + j];
    return c;
}

Matrix4 identity() {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}

/// Exact for quarter turns, so that they lose no bit.
void exact_turn(double degrees, double& cosine, double& sine) {
    const double quarter = degrees / 90;
    if (quarter == std::floor(quarter) && std::abs(quarter) < 1e6) {
        const int turns = ((static_cast<int>(quarter) % 4) + 4) % 4;
        cosine = turns == 0 ? 1 : turns == 2 ? -1 : 0;
        sine = turns == 1 ? 1 : turns == 3 ? -1 : 0;
        return;
    }
    constexpr double kRadians = 3.14159265358979323846 / 180;
    cosine = std::cos(degrees * kRadians);
    sine = std::sin(degrees * kRadians);
}

Matrix4 rotation(std::size_t axis, double degrees) {
    Matrix4 matrix = identity();
    double c = 1, s = 0;
    exact_turn(degrees, c, s);
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    matrix[4 * a + a] = c, matrix[4 * a + b] = -s;
    matrix[4 * b + a] = s, matrix[4 * b + b] = c;
    return matrix;
}

void run_turn(const MeshArguments& arguments) {
    Matrix4 matrix = identity();
    for (std::size_t axis = 0; axis < arguments.rotate.size(); ++axis)
        matrix = product(rotation(axis, arguments.rotate[axis]), matrix);
    if (!arguments.mirror.empty())
        matrix[5 * static_cast<std::size_t>(arguments.mirror[0] - 'x')] *= -1;
    if (!arguments.mirror.empty() && !arguments.rotate.empty())
        throw std::runtime_error("--rotate and --mirror together: turn twice, the order matters");
    if (arguments.mirror.empty() && arguments.rotate.empty() && !arguments.inside_out)
        throw std::runtime_error("give --rotate X,Y,Z, --mirror AXIS or --inside-out");
    const Session session(arguments.common.num_threads);
    const Mesh mesh(session, arguments.in);
    Mesh turned = transform_mesh(session, mesh, matrix);
    if (arguments.inside_out) turned = turn_mesh_over(session, turned);
    finish(session, arguments, "turned", mesh, turned);
}

void run_decimate(const MeshArguments& arguments) {
    const Session session(arguments.common.num_threads);
    const Mesh mesh(session, arguments.in);
    std::uint64_t vertices = arguments.vertices;
    if (arguments.share > 0)
        vertices = static_cast<std::uint64_t>(
            std::llround(arguments.share * static_cast<double>(mesh.vertex_count())));
    if (vertices == 0) throw std::runtime_error("give --vertices or --share");
    finish(session, arguments, "decimated", mesh, decimate_mesh(session, mesh, vertices));
}

CLI::App& add(CLI::App& parent, const char* name, const char* purpose,
              const std::shared_ptr<MeshArguments>& arguments, const char* example,
              void (*run)(const MeshArguments&), bool writes = true) {
    CLI::App& command = *parent.add_subcommand(name, purpose);
    command.add_option("in", arguments->in, "mesh file")->required();
    if (writes)
        command.add_option("out", arguments->out, "mesh file to write, its kind by its name")
            ->required();
    add_common_options(command, arguments->common);
    command.footer(std::string("Example: mien mesh ") + example);
    command.callback([arguments, run] { run(*arguments); });
    return command;
}

}  // namespace

void add_mesh_commands(CLI::App& app) {
    CLI::App& mesh = *app.add_subcommand("mesh", "look at meshes and mend them");
    mesh.require_subcommand(1);
    const auto fresh = [] { return std::make_shared<MeshArguments>(); };
    add(mesh, "info", "say what a mesh is and what is wrong with it", fresh(), "info scan.obj",
        run_info, false);
    auto arguments = fresh();
    add(mesh, "clean", "drop doubled, degenerate and unused parts; wind all triangles alike",
        arguments, "clean scan.obj clean.ply --min-triangles 500", run_clean)
        .add_option("--min-triangles", arguments->min_triangles, "pieces of fewer go")
        ->capture_default_str();
    add(mesh, "convert", "write a mesh as another kind of file", fresh(),
        "convert scan.obj scan.ply", run_convert);
    arguments = fresh();
    CLI::App& scale = add(mesh, "scale", "bring a mesh to millimetres, or scale it", arguments,
                          "scale scan.obj scan_mm.ply --units in", run_scale);
    auto* unit = scale.add_option(
        "--units", arguments->unit,
        "what the file is in: mm, cm, dm, m, km, in, ft, or the mm that one unit is long");
    scale.add_option("--factor", arguments->factor, "every coordinate times this")->excludes(unit);
    arguments = fresh();
    CLI::App& turn = add(mesh, "turn", "rotate, mirror or turn a mesh inside out", arguments,
                         "turn scan.ply turned.ply --rotate 180,0,0", run_turn);
    turn.add_option("--rotate", arguments->rotate, "degrees about x, then y, then z")
        ->delimiter(',')
        ->expected(3);
    turn.add_option("--mirror", arguments->mirror, "negate this axis; outside stays outside")
        ->check(CLI::IsMember({"x", "y", "z"}));
    turn.add_flag("--inside-out", arguments->inside_out, "wind every triangle the other way");
    arguments = fresh();
    CLI::App& decimate = add(mesh, "decimate", "fewer vertices, the shape kept", arguments,
                             "decimate scan.ply small.ply --vertices 20000", run_decimate);
    auto* vertices = decimate.add_option("--vertices", arguments->vertices, "how many stay")
                         ->check(CLI::Range(std::uint64_t{4}, std::uint64_t{1} << 31));
    decimate.add_option("--share", arguments->share, "or which share of them")
        ->check(CLI::Range(0.0, 1.0))
        ->excludes(vertices);
}

}  // namespace mien::cli
