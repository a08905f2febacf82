// mien transfer: landmarks, contours, zones and fields between a fitted template and its scan, both
// ways.
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "commands.hpp"
#include "fields.hpp"
#include "topology.hpp"

namespace mien::cli {
namespace {

struct TransferArguments {
    std::string model, fitted, scan, what = "landmarks", out, field, picture, to, correspondence;
    bool to_template = false;
    double max_distance = 0;
    Common common;
};

/// Where points went on a surface.
struct Carried {
    std::vector<std::uint32_t> triangles;  ///< 0xFFFFFFFF: lost
    std::vector<Position> barycentric, places;
};

Carried carry(const Session& session, const Mesh& surface, const std::vector<Position>& points,
              double max_distance) {
    Carried carried{std::vector<std::uint32_t>(points.size()), std::vector<Position>(points.size()),
                    std::vector<Position>(points.size())};
    if (points.empty()) return carried;
    const mien_array_view view{points.data(), points.size(), sizeof(Position), MIEN_DTYPE_F64, 0};
    std::uint64_t count = 0;
    detail::call(mien_surface_transfer_points, session.get(), surface.get(), &view, max_distance,
                 carried.triangles.data(), carried.barycentric.front().data(),
                 carried.places.front().data(), std::uint64_t{points.size()}, &count);
    return carried;
}

constexpr std::uint32_t kLost = 0xFFFFFFFFu;

/// The vertex of the triangle that a place is nearest to; the triangle itself on a cloud of points.
std::uint32_t nearest_vertex(const std::vector<Triangle>& triangles, const Carried& carried,
                             std::size_t at) {
    if (triangles.empty()) return carried.triangles[at];
    const Position& b = carried.barycentric[at];
    const std::size_t corner = b[0] >= b[1] && b[0] >= b[2] ? 0 : b[1] >= b[2] ? 1 : 2;
    return triangles[carried.triangles[at]][corner];
}

/// A field over `from`'s vertices at the vertices of `to`: interpolated at the nearest place on
/// `from`, not a number where that is too far.
std::vector<double> carry_field(const Session& session, const Mesh& from,
                                const std::vector<double>& field, const Mesh& to,
                                double max_distance) {
    const std::vector<Triangle> triangles = from.triangles();
    const Carried carried = carry(session, from, to.positions(), max_distance);
    std::vector<double> out(carried.triangles.size(), std::nan(""));
    for (std::size_t v = 0; v < out.size(); ++v) {
        const std::uint32_t triangle = carried.triangles[v];
        if (triangle == kLost) continue;
        if (triangles.empty()) {
            out[v] = field[triangle];
            continue;
        }
        double value = 0;
        for (std::size_t k = 0; k < 3; ++k)
            // A corner without weight has no say, whatever stands there.
            if (carried.barycentric[v][k] > 0)
                value += carried.barycentric[v][k] * field[triangles[triangle][k]];
        out[v] = value;
    }
    return out;
}

struct Line {
    std::string name;
    std::vector<Position> points;
};

/// {"contours": {name: [place or vertex, ...]}}: lines along a surface.
std::vector<Line> read_contours(const nlohmann::json& file, const std::string& path,
                                const std::vector<Position>& vertices) {
    std::vector<Line> lines;
    if (!file["contours"].is_object())
        throw std::runtime_error(path + ": expected {\"contours\": {name: [place, ...]}}");
    for (const auto& [name, list] : file["contours"].items()) {
        Line line{name, {}};
        for (const nlohmann::json& entry : list) {
            if (entry.is_number_unsigned() && entry.get<std::uint64_t>() < vertices.size()) {
                line.points.push_back(vertices[entry.get<std::size_t>()]);
                continue;
            }
            if (!entry.is_array() || entry.size() != 3 || !entry[0].is_number() ||
                !entry[1].is_number() || !entry[2].is_number())
                throw std::runtime_error(path + ": contour '" + name + "' holds " + entry.dump() +
                                         ", which is neither a place [x, y, z] nor a vertex");
            line.points.push_back(entry.get<Position>());
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

/// Contours as places on the other surface, and as its vertices; lost points are left out.
nlohmann::json carry_contours(const Session& session, const TransferArguments& arguments,
                              const nlohmann::json& file, const Mesh& from, const Mesh& to) {
    nlohmann::json result;
    const std::vector<Triangle> triangles = to.triangles();
    for (const Line& line : read_contours(file, arguments.what, from.positions())) {
        const Carried carried = carry(session, to, line.points, arguments.max_distance);
        nlohmann::json places = nlohmann::json::array(), vertices = nlohmann::json::array();
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            if (carried.triangles[i] == kLost) continue;
            places.push_back(carried.places[i]);
            const std::uint32_t vertex = nearest_vertex(triangles, carried, i);
            if (vertices.empty() || vertices.back() != vertex) vertices.push_back(vertex);
        }
        result[arguments.to_template ? "places" : "contours"][line.name] = places;
        result[arguments.to_template ? "contours" : "vertices"][line.name] = vertices;
    }
    return result;
}

// FILE: {"points": {...}} go to the nearest place on the scan, {"zones": {...}} of the template to
// scan vertices.
nlohmann::json transfer_file(const Session& session, const TransferArguments& arguments,
                             const Mesh& fitted, const Mesh& scan) {
    const nlohmann::json file = read_json(arguments.what);
    nlohmann::json result;
    if (file.is_object() && file.contains("contours")) {
        result = carry_contours(session, arguments, file, fitted, scan);
    } else if (file.is_object() && file.contains("zones")) {
        for (const auto& [name, vertices] : read_zones(arguments.what))
            result["zones"][name] =
                transfer_zone(session, fitted, vertices, scan, arguments.max_distance);
    } else if (file.is_object() && file.contains("vertices")) {
        const std::vector<Position> places = fitted.positions();
        for (const auto& [name, vertex] : read_landmark_vertices(arguments.what)) {
            if (vertex >= places.size())
                throw std::runtime_error(arguments.what + ": '" + name + "' is vertex " +
                                         std::to_string(vertex) +
                                         ", which the fitted mesh does not have");
            result["points"][name] =
                transfer_points(session, scan, {places[vertex]}, arguments.max_distance)[0];
        }
    } else {
        for (const NamedPoint& point : read_landmark_points(arguments.what))
            result["points"][point.name] =
                transfer_points(session, scan, {point.point}, arguments.max_distance)[0];
    }
    return result;
}

/// What was marked on the scan, on the template: landmarks as vertices, with how far away they are.
nlohmann::json landmarks_to_template(const Session& session, const TransferArguments& arguments,
                                     const Mesh& fitted) {
    const std::vector<NamedPoint> points = read_landmark_points(arguments.what);
    std::vector<Position> places;
    places.reserve(points.size());
    for (const NamedPoint& point : points) places.push_back(point.point);
    const Carried carried = carry(session, fitted, places, arguments.max_distance);
    const std::vector<Triangle> triangles = fitted.triangles();
    nlohmann::json result{{"vertices", nlohmann::json::object()},
                          {"distances_mm", nlohmann::json::object()},
                          {"lost", nlohmann::json::array()}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::string& name = points[i].name;
        if (carried.triangles[i] == kLost) {
            result["lost"].push_back(name);
            continue;
        }
        const Position &a = places[i], &b = carried.places[i];
        result["vertices"][name] = nearest_vertex(triangles, carried, i);
        result["distances_mm"][name] =
            std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
    }
    return result;
}

nlohmann::json transfer_to_template(const Session& session, const TransferArguments& arguments,
                                    const Mesh& fitted, const Mesh& scan) {
    if (arguments.what == "landmarks" || arguments.what == "zones")
        throw CLI::ValidationError("--what",
                                   "with --to-template give the file of what was marked "
                                   "on the scan");
    // Other kinds of landmark files are no JSON of ours.
    nlohmann::json file;
    if (arguments.what.size() > 5 &&
        arguments.what.compare(arguments.what.size() - 5, 5, ".json") == 0)
        file = read_json(arguments.what);
    if (file.is_object() && file.contains("contours"))
        return carry_contours(session, arguments, file, scan, fitted);
    if (file.is_object() && file.contains("zones")) {
        nlohmann::json result;
        for (const auto& [name, vertices] : read_zones(arguments.what))
            result["zones"][name] =
                transfer_zone(session, scan, vertices, fitted, arguments.max_distance);
        return result;
    }
    return landmarks_to_template(session, arguments, fitted);
}

void run_field(const Session& session, const TransferArguments& arguments, const Mesh& fitted,
               const Mesh& scan) {
    const Mesh &from = arguments.to_template ? scan : fitted,
               &to = arguments.to_template ? fitted : scan;
    const std::vector<double> given = read_field(arguments.field);
    if (given.size() != from.vertex_count())
        throw std::runtime_error(arguments.field + ": has " + std::to_string(given.size()) +
                                 " values, the " + (arguments.to_template ? "scan" : "template") +
                                 " has " + std::to_string(from.vertex_count()) + " vertices");
    const std::vector<double> field = carry_field(session, from, given, to, arguments.max_distance);
    write_json(arguments.out, field);  // not a number becomes null
    const FieldSummary summary = summary_of(field);
    std::printf("least %.6g, mean %.6g, largest %.6g\n", summary.least, summary.mean, summary.most);
    draw_field(arguments.picture, to, field, {});
    write_report(
        arguments.common,
        {{"field", arguments.field}, {"out", arguments.out}, {"values", summary_json(summary)}});
}

/// Nothing that lies near the other surface is a mistake of files or frames; lists that became
/// empty are told.
void expect_arrivals(const nlohmann::json& result, const TransferArguments& arguments) {
    std::size_t arrived = 0;
    std::string lost;
    for (const auto& [kind, lists] : result.items()) {
        if (kind == "distances_mm" || kind == "lost" || !lists.is_object()) continue;
        for (const auto& [name, list] : lists.items()) {
            const bool no_place = list.is_array() && !list.empty() && list[0].is_number() &&
                                  std::isnan(list[0].get<double>());
            const bool empty = list.empty() || no_place;
            if (empty && lost.find("'" + name + "'") == std::string::npos)
                lost += (lost.empty() ? "'" : ", '") + name + "'";
            arrived += empty ? 0 : 1;
        }
    }
    if (arrived == 0)
        throw std::runtime_error(
            arguments.scan + ": nothing of " + arguments.what +
            " lies near enough to the other surface: is " + arguments.fitted +
            " the fit of this scan, in its frame, and does --max-distance fit?");
    if (!lost.empty())
        std::fprintf(stderr, "mien: warning: %s: too far from the other surface, so empty: %s\n",
                     arguments.scan.c_str(), lost.c_str());
}

void run_transfer(const TransferArguments& arguments) {
    const Session session(arguments.common.num_threads);
    if (!arguments.to.empty() || !arguments.correspondence.empty()) {
        if (arguments.out.empty() && (arguments.to.empty() || arguments.correspondence.empty()))
            throw CLI::RequiredError("--out");
        if (!arguments.out.empty() && arguments.fitted.empty())
            throw CLI::RequiredError("--fitted");
        write_report(arguments.common,
                     transfer_topology(session, {arguments.model, arguments.fitted, arguments.to,
                                                 arguments.correspondence, arguments.out}));
        return;
    }
    for (const auto& [name, value] :
         {std::pair{"--model", arguments.model}, std::pair{"--fitted", arguments.fitted},
          std::pair{"--scan", arguments.scan}, std::pair{"--out", arguments.out}})
        if (value.empty()) throw CLI::RequiredError(name);
    const Model model(session, arguments.model);
    const Mesh fitted(session, arguments.fitted), scan(session, arguments.scan);
    if (!arguments.field.empty()) return run_field(session, arguments, fitted, scan);
    nlohmann::json result;
    if (arguments.to_template)
        result = transfer_to_template(session, arguments, fitted, scan);
    else if (arguments.what == "landmarks" || arguments.what == "zones")
        result = nlohmann::json::parse(
            transfer_json(session, model, fitted, scan,
                          arguments.what == "zones" ? MIEN_TRANSFER_ZONES : MIEN_TRANSFER_LANDMARKS,
                          arguments.max_distance));
    else
        result = transfer_file(session, arguments, fitted, scan);
    expect_arrivals(result, arguments);
    write_json(arguments.out, result);
    write_report(arguments.common, {{"what", arguments.what}, {"out", arguments.out}});
}

}  // namespace

void add_transfer_commands(CLI::App& app) {
    auto* transfer = app.add_subcommand(
        "transfer",
        "carry landmarks, contours, zones or fields between a fitted template and its "
        "scan");
    auto carried = std::make_shared<TransferArguments>();
    transfer->add_option("--model", carried->model, "deformation model");
    transfer->add_option("--fitted", carried->fitted, "the template after registration");
    transfer->add_option("--scan", carried->scan, "the scan, in the same frame");
    auto* what = transfer
                     ->add_option("--what", carried->what,
                                  "landmarks, zones, or a JSON file with points, vertices, zones "
                                  "or contours (lists of places or vertices)")
                     ->capture_default_str();
    transfer
        ->add_option("--field", carried->field,
                     "one number per vertex instead: interpolated on the other surface")
        ->excludes(what);
    transfer->add_flag("--to-template", carried->to_template,
                       "from the scan to the template, instead of to the scan");
    transfer
        ->add_option("--max-distance", carried->max_distance,
                     "mm beyond which a place is lost; 0: 10, below 0: no limit")
        ->capture_default_str();
    transfer
        ->add_option("--to", carried->to,
                     "another template, fitted to this model's template: the face in its topology")
        ->excludes(what);
    transfer->add_option("--correspondence", carried->correspondence,
                         "file that keeps where the other template lies on this one: written with "
                         "--to, read without");
    transfer->add_option("--out", carried->out, "JSON file; with --to or --correspondence a mesh");
    transfer->add_option("--picture", carried->picture, "with --field: PNG of the carried field");
    add_common_options(*transfer, carried->common);
    transfer->footer(
        "Example: mien transfer --model face.safetensors --fitted fitted.ply --scan scan.ply "
        "--what zones --out zones.json\n"
        "         mien transfer --model face.safetensors --fitted fitted.ply --scan scan.ply "
        "--what marked.json --to-template --out vertices.json\n"
        "         mien transfer --model face.safetensors --to studio_on_template.ply "
        "--correspondence studio.json\n"
        "         mien transfer --correspondence studio.json --fitted fitted.ply --out "
        "fitted_studio.ply");
    transfer->callback([carried] { run_transfer(*carried); });
}

}  // namespace mien::cli
