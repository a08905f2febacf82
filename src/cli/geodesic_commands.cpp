// mien measure geodesic: how far every vertex is from some places, along the surface.
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "commands.hpp"
#include "fields.hpp"
#include "measure_faces.hpp"

namespace mien::cli {
namespace {

struct GeodesicCommand {
    Common common;
    std::string mesh, model, landmarks, zones, zone, field, picture, boundary = "neumann";
    std::vector<std::string> from;
    double time_factor = 4;
};

/// Vertex numbers, and names of a file of landmark vertices or of the model's landmarks.
std::vector<std::uint32_t> sources_of(const GeodesicCommand& o, const nlohmann::json& named) {
    std::vector<std::uint32_t> sources;
    for (const std::string& word : o.from) {
        if (!word.empty() && word.find_first_not_of("0123456789") == std::string::npos &&
            word.size() < 10) {
            sources.push_back(static_cast<std::uint32_t>(std::stoul(word)));
            continue;
        }
        if (!named.contains(word))
            throw CLI::ValidationError("--from",
                                       "'" + word + "' is neither a vertex nor a landmark of " +
                                           (o.landmarks.empty() ? "--model" : o.landmarks));
        sources.push_back(named[word].get<std::uint32_t>());
    }
    if (!o.zone.empty())
        for (const std::uint32_t vertex : zone_vertices(o.zones, o.zone)) sources.push_back(vertex);
    if (sources.empty())
        throw CLI::ValidationError("measure geodesic", "give --from or --zone to measure from");
    return sources;
}

void run_geodesic(const GeodesicCommand& o) {
    if (o.mesh.empty() == o.model.empty())
        throw CLI::ValidationError("measure geodesic", "give either a mesh or --model");
    const Session session(o.common.num_threads);
    nlohmann::json named = nlohmann::json::object();
    const Mesh mesh = [&] {
        if (o.model.empty()) return Mesh(session, o.mesh);
        const Model model(session, o.model);
        named = nlohmann::json::parse(model.json())["landmarks"];
        return model.mesh();
    }();
    if (!o.landmarks.empty())
        for (const auto& [name, vertex] : read_landmark_vertices(o.landmarks)) named[name] = vertex;
    const std::vector<std::uint32_t> sources = sources_of(o, named);
    GeodesicSettings settings;
    settings.heat_boundary = o.boundary == "neumann"     ? MIEN_HEAT_NEUMANN
                             : o.boundary == "dirichlet" ? MIEN_HEAT_DIRICHLET
                                                         : MIEN_HEAT_AVERAGE;
    settings.heat_time_factor = o.time_factor;
    settings.progress = progress_bar();
    std::vector<double> field = geodesic_distances(session, mesh, sources, settings);
    const FieldSummary summary = summary_of(field);
    std::size_t apart = 0;
    for (const double value : field) apart += std::isfinite(value) ? 0 : 1;
    std::printf("from %zu vertices: mean %.4f mm, farthest %.4f mm\n", sources.size(), summary.mean,
                summary.most);
    if (apart > 0) std::printf("%zu vertices on pieces without a source\n", apart);
    nlohmann::json landmarks = nlohmann::json::object();
    for (const auto& [name, vertex] : named.items())
        if (vertex.get<std::size_t>() < field.size() &&
            std::isfinite(field[vertex.get<std::size_t>()]))
            landmarks[name] = field[vertex.get<std::size_t>()];
    if (!o.field.empty()) write_json(o.field, field);  // infinity becomes null
    FieldPicture picture{"mm along the surface", "", false, 0.0, {}};
    const auto places = mesh.positions();
    for (const std::uint32_t source : sources) picture.points.push_back(places[source]);
    if (sources.size() > 100) picture.points.clear();
    draw_field(o.picture, mesh, field, picture);
    write_report(o.common, {{"sources", sources},
                            {"distance_mm", summary_json(summary)},
                            {"vertices_without_source", apart},
                            {"landmarks_mm", landmarks}});
}

}  // namespace

void add_geodesic_command(CLI::App& measure) {
    auto o = std::make_shared<GeodesicCommand>();
    CLI::App* command = measure.add_subcommand(
        "geodesic", "distance of every vertex from some places, along the surface");
    command->add_option("mesh", o->mesh, "mesh with triangles");
    command->add_option("--model", o->model, "a model's template instead, with its landmarks");
    command
        ->add_option("--from", o->from,
                     "vertices or names of landmarks, comma-separated; several: the nearest counts")
        ->delimiter(',');
    command->add_option("--landmarks", o->landmarks, "landmark vertices of the mesh, JSON or CSV");
    command->add_option("--zones", o->zones, "zone file of the mesh");
    command->add_option("--zone", o->zone, "zones to measure from, comma-separated");
    command->add_option("--boundary", o->boundary, "heat at borders")
        ->check(CLI::IsMember({"neumann", "dirichlet", "average"}))
        ->capture_default_str();
    command->add_option("--time-factor", o->time_factor, "heat time in mean edges squared")
        ->capture_default_str();
    command->add_option("--field", o->field,
                        "JSON list of mm per vertex; null on pieces without a source");
    command->add_option("--picture", o->picture, "PNG of the distances");
    add_common_options(*command, o->common);
    command->footer(
        "Example: mien measure geodesic template.ply --landmarks landmarks.json --from pronasale "
        "--field distance.json --picture distance.png");
    command->callback([o] { run_geodesic(*o); });
}

}  // namespace mien::cli
