// mien render: a mesh as a picture.
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "commands.hpp"
#include "fields.hpp"
#include "render.hpp"

namespace mien::cli {
namespace {

struct RenderCommand {
    Common common;
    std::string mesh, scalar, compare, landmarks, zones, out, label, title;
    std::vector<std::string> views{"front", "left45", "left"}, beside, captions;
    int size = 480;
    double low = std::nan(""), high = std::nan("");
    bool diverging = false, plain = false, is_signed = false;
};

/// Distance per vertex between meshes of one topology; signed along the normals of the first if
/// asked.
std::vector<double> distances(const MeshArrays& mesh, const MeshArrays& other, bool with_sign) {
    if (mesh.positions.size() != other.positions.size())
        throw std::runtime_error(
            "--compare: the meshes have " + std::to_string(mesh.positions.size()) + " and " +
            std::to_string(other.positions.size()) +
            " vertices; a comparison vertex by vertex needs the same topology");
    std::vector<double> out(mesh.positions.size());
    std::vector<Position> normals(out.size(), Position{0, 0, 0});
    for (const Triangle& t : mesh.triangles) {
        Position a{}, b{};
        for (std::size_t k = 0; k < 3; ++k) {
            a[k] = mesh.positions[t[1]][k] - mesh.positions[t[0]][k];
            b[k] = mesh.positions[t[2]][k] - mesh.positions[t[0]][k];
        }
        const Position n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]};
        for (std::uint32_t v : t)
            for (std::size_t k = 0; k < 3; ++k) normals[v][k] += n[k];
    }
    for (std::size_t v = 0; v < out.size(); ++v) {
        double square = 0, along = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double d = other.positions[v][k] - mesh.positions[v][k];
            square += d * d;
            along += d * normals[v][k];
        }
        out[v] = std::sqrt(square) * (with_sign && along < 0 ? -1 : 1);
    }
    return out;
}

/// The meshes of --beside in their own colours, then the mesh itself, all seen by one camera.
Image beside_one_another(const Session& session, const RenderCommand& o, const MeshArrays& mesh,
                         RenderOptions options) {
    if (!o.captions.empty() && o.captions.size() != o.beside.size() + 1)
        throw std::runtime_error("--captions: give " + std::to_string(o.beside.size() + 1) +
                                 ", one for each --beside and one for the mesh");
    if (o.beside.empty()) {
        if (!o.captions.empty()) options.title = o.captions.front();
        return render_mesh(mesh, options);
    }
    std::vector<MeshArrays> others;
    MeshArrays all = mesh;
    const Mesh given(session, o.mesh);
    for (const std::string& path : o.beside) {
        const Mesh other(session, path);
        check_same_unit(given, other);
        others.push_back(arrays_of(other));
        all.positions.insert(all.positions.end(), others.back().positions.begin(),
                             others.back().positions.end());
    }
    options.framing = &all;
    std::vector<Image> parts;
    for (std::size_t k = 0; k <= others.size(); ++k) {
        RenderOptions own = options;
        if (!o.captions.empty()) own.title = o.captions[k];
        if (k < others.size()) {
            own.scalar.clear();
            own.points.clear();
            if (o.captions.empty()) own.title.clear();
        }
        parts.push_back(render_mesh(k < others.size() ? others[k] : mesh, own));
    }
    return stack_images(parts, true);
}

void run(const RenderCommand& o) {
    if (o.low >= o.high) throw CLI::ValidationError("--min", "must be below --max");
    const Session session(o.common.num_threads);
    const Mesh given(session, o.mesh);
    MeshArrays mesh = arrays_of(given);
    RenderOptions options;
    options.views = o.views;
    options.size = o.size;
    options.low = o.low;
    options.high = o.high;
    options.label = o.label;
    options.title = o.title;
    options.use_colors = !o.plain;
    if (o.diverging || o.is_signed) options.color_map = ColorMap::diverging;
    if (!o.scalar.empty()) options.scalar = read_field(o.scalar);
    if (!o.compare.empty()) {
        const Mesh other(session, o.compare);
        check_same_unit(given, other);
        options.scalar = distances(mesh, arrays_of(other), o.is_signed);
        if (options.label.empty())
            options.label = o.is_signed ? "signed distance, mm" : "distance, mm";
        if (std::isnan(options.low) && !o.is_signed) options.low = 0;
    }
    if (!o.landmarks.empty()) {
        const nlohmann::json file = read_json(o.landmarks);
        if (file.is_object() && file.contains("points")) {
            for (const NamedPoint& p : read_landmark_points(o.landmarks))
                options.points.push_back(p.point);
        } else {
            for (const auto& [name, vertex] : read_landmark_vertices(o.landmarks)) {
                if (vertex >= mesh.positions.size())
                    throw std::runtime_error(o.landmarks + ": landmark '" + name + "' is vertex " +
                                             std::to_string(vertex) + " of a mesh with " +
                                             std::to_string(mesh.positions.size()));
                options.points.push_back(mesh.positions[vertex]);
            }
        }
    }
    if (!o.zones.empty()) {
        mesh.colors.assign(mesh.positions.size(), Color{190, 190, 190});
        int k = 0;
        for (const auto& [name, vertices] : read_zones(o.zones)) {
            const Rgb color = map_color(ColorMap::sequential,
                                        0.15 + 0.618034 * k - std::floor(0.15 + 0.618034 * k));
            if (name != "face") ++k;
            for (std::uint32_t v : vertices) {
                if (v >= mesh.positions.size())
                    throw std::runtime_error(o.zones + ": zone '" + name + "' names vertex " +
                                             std::to_string(v));
                if (name != "face") mesh.colors[v] = color;
            }
        }
    }
    write_png(o.out, beside_one_another(session, o, mesh, options));
    nlohmann::json report{{"mesh", o.mesh}, {"out", o.out}, {"vertices", mesh.positions.size()}};
    if (!options.scalar.empty()) {
        double low = HUGE_VAL, high = -HUGE_VAL, sum = 0;
        std::size_t count = 0;
        for (double s : options.scalar)
            if (std::isfinite(s)) {
                low = std::min(low, s);
                high = std::max(high, s);
                sum += s;
                ++count;
            }
        if (count > 0) {
            report["scalar"] = {
                {"min", low}, {"mean", sum / static_cast<double>(count)}, {"max", high}};
            std::printf("scalar: min %.6g mean %.6g max %.6g\n", low,
                        sum / static_cast<double>(count), high);
        }
    }
    write_report(o.common, report);
}

}  // namespace

void add_render_commands(CLI::App& app) {
    auto options = std::make_shared<RenderCommand>();
    CLI::App* command = app.add_subcommand("render", "Draw a mesh as a picture (PNG)");
    command->add_option("mesh", options->mesh, "mesh file")->required();
    command->add_option("--out", options->out, "PNG file to write")->required();
    auto* scalar = command->add_option("--scalar", options->scalar,
                                       "one number per vertex (text, CSV or JSON): heat map");
    auto* compare = command
                        ->add_option("--compare", options->compare,
                                     "mesh of the same topology: heat map of the distance, mm")
                        ->excludes(scalar);
    command
        ->add_flag("--signed", options->is_signed,
                   "with --compare: positive outwards, diverging colours")
        ->needs(compare);
    command->add_flag("--diverging", options->diverging,
                      "blue - white - red instead of dark to bright");
    command->add_option("--min", options->low, "value at the lower end of the colours");
    command->add_option("--max", options->high, "value at the upper end of the colours");
    command->add_option("--label", options->label, "text beside the colour bar");
    command->add_option("--title", options->title, "text above the picture");
    command
        ->add_option("--views", options->views,
                     "front, left, right, left45, right45, back, top or degrees, comma-separated")
        ->delimiter(',');
    command
        ->add_option("--beside", options->beside,
                     "another mesh, drawn to the left in its own colours; may be repeated")
        ->take_all()
        ->allow_extra_args(false);
    command
        ->add_option("--captions", options->captions,
                     "titles, comma-separated: one per --beside, then the mesh's")
        ->delimiter(',');
    command->add_option("--size", options->size, "height of a view in pixels")
        ->check(CLI::Range(32, 4096))
        ->capture_default_str();
    command->add_option("--landmarks", options->landmarks, "landmark file, drawn as dots");
    command->add_option("--zones", options->zones, "zone file of the mesh, drawn in colours");
    command->add_flag("--no-colors", options->plain, "ignore vertex colours");
    add_common_options(*command, options->common);
    command->footer(
        "Example: mien render fitted.ply --compare truth.ply --max 3 --views front,left45 --out "
        "error.png");
    command->callback([options] { run(*options); });
}

}  // namespace mien::cli
