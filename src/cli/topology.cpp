#include "topology.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace mien::cli {
namespace {

constexpr int kCorrespondenceFormat = 1;
// Farther from this template than that a vertex of the other stands for something that this one
// has not (hair, teeth): it is carried along, and counted.
constexpr double kBesideMm = 10;

Position minus(const Position& a, const Position& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Position cross(const Position& a, const Position& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Position& a, const Position& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Position unit(Position a) {
    const double length = std::sqrt(dot(a, a));
    if (length > 0)
        for (double& x : a) x /= length;
    return a;
}

/// Three directions that turn with a triangle: an edge, its normal, and what is across both.
std::array<Position, 3> frame_of(const std::vector<Position>& places, const Triangle& t) {
    const Position edge = unit(minus(places[t[1]], places[t[0]]));
    const Position normal = unit(cross(edge, minus(places[t[2]], places[t[0]])));
    return {edge, cross(normal, edge), normal};
}

Position place_in(const std::vector<Position>& places, const Triangle& t, const Position& weights) {
    Position place{0, 0, 0};
    for (std::size_t corner = 0; corner < 3; ++corner)
        for (std::size_t k = 0; k < 3; ++k) place[k] += weights[corner] * places[t[corner]][k];
    return place;
}

/// Where the vertices of the other template lie on this one.
struct Correspondence {
    std::size_t from_vertices = 0;
    std::vector<Triangle> corners;      ///< of this template's triangle under each vertex
    std::vector<Position> barycentric;  ///< in it
    std::vector<Position> offset;       ///< from there, mm, in the triangle's own directions
    std::vector<Triangle> triangles;    ///< of the other template
};

Correspondence find_correspondence(const Session& session, const Mesh& from, const Mesh& to) {
    Correspondence found;
    const std::vector<Position> places = from.positions(), vertices = to.positions();
    const std::vector<Triangle> triangles = from.triangles();
    if (triangles.empty())
        throw std::runtime_error("the model's template has no triangles to lie on");
    std::vector<std::uint32_t> under(vertices.size());
    found.from_vertices = places.size();
    found.barycentric.resize(vertices.size());
    const mien_array_view view{vertices.data(), vertices.size(), sizeof(Position), MIEN_DTYPE_F64,
                               0};
    std::uint64_t count = 0;
    const double no_limit = -1;
    detail::call(mien_surface_transfer_points, session.get(), from.get(), &view, no_limit,
                 under.data(), found.barycentric.front().data(), nullptr,
                 std::uint64_t{under.size()}, &count);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const Triangle& t = triangles[under[v]];
        const Position away = minus(vertices[v], place_in(places, t, found.barycentric[v]));
        const auto frame = frame_of(places, t);
        found.corners.push_back(t);
        found.offset.push_back({dot(away, frame[0]), dot(away, frame[1]), dot(away, frame[2])});
    }
    found.triangles = to.triangles();
    return found;
}

nlohmann::json as_json(const Correspondence& c) {
    return {{"mien_correspondence", kCorrespondenceFormat},
            {"from_vertices", c.from_vertices},
            {"corners", c.corners},
            {"barycentric", c.barycentric},
            {"offset_mm", c.offset},
            {"triangles", c.triangles}};
}

Correspondence read_correspondence(const std::string& path) {
    const nlohmann::json file = read_json(path);
    if (!file.is_object() || file.value("mien_correspondence", 0) != kCorrespondenceFormat)
        throw std::runtime_error(path +
                                 ": is no correspondence of templates (mien transfer --to writes "
                                 "one)");
    Correspondence c;
    try {
        c.from_vertices = file.at("from_vertices").get<std::size_t>();
        c.corners = file.at("corners").get<std::vector<Triangle>>();
        c.barycentric = file.at("barycentric").get<std::vector<Position>>();
        c.offset = file.at("offset_mm").get<std::vector<Position>>();
        c.triangles = file.at("triangles").get<std::vector<Triangle>>();
    } catch (const nlohmann::json::exception& failure) {
        throw std::runtime_error(path + ": " + failure.what());
    }
    const std::size_t count = c.corners.size();
    const auto beyond = [](const std::vector<Triangle>& triangles, std::size_t end) {
        return std::any_of(triangles.begin(), triangles.end(), [end](const Triangle& t) {
            return t[0] >= end || t[1] >= end || t[2] >= end;
        });
    };
    if (count == 0 || c.barycentric.size() != count || c.offset.size() != count ||
        beyond(c.corners, c.from_vertices) || beyond(c.triangles, count))
        throw std::runtime_error(path + ": its lists do not fit each other");
    return c;
}

std::vector<Position> carried(const Correspondence& c, const std::vector<Position>& places) {
    std::vector<Position> vertices;
    vertices.reserve(c.corners.size());
    for (std::size_t v = 0; v < c.corners.size(); ++v) {
        Position place = place_in(places, c.corners[v], c.barycentric[v]);
        const auto frame = frame_of(places, c.corners[v]);
        for (std::size_t direction = 0; direction < 3; ++direction)
            for (std::size_t k = 0; k < 3; ++k)
                place[k] += c.offset[v][direction] * frame[direction][k];
        vertices.push_back(place);
    }
    return vertices;
}

}  // namespace

nlohmann::json transfer_topology(const Session& session, const TopologyArguments& arguments) {
    Correspondence c;
    if (arguments.to.empty()) {
        c = read_correspondence(arguments.correspondence);
    } else {
        if (arguments.model.empty()) throw CLI::RequiredError("--model (whose template --to fits)");
        const Model model(session, arguments.model);
        c = find_correspondence(session, model.mesh(), Mesh(session, arguments.to));
        if (!arguments.correspondence.empty()) write_json(arguments.correspondence, as_json(c));
    }
    std::size_t beside = 0;
    for (const Position& offset : c.offset) beside += dot(offset, offset) > kBesideMm * kBesideMm;
    nlohmann::json report{
        {"vertices", c.corners.size()}, {"triangles", c.triangles.size()}, {"beside", beside}};
    if (beside > 0)
        std::printf(
            "%zu of %zu vertices lie more than %g mm beside the model's template: they are "
            "carried along with it\n",
            beside, c.corners.size(), kBesideMm);
    if (arguments.out.empty()) return report;
    const std::vector<Position> places = Mesh(session, arguments.fitted).positions();
    if (places.size() != c.from_vertices)
        throw std::runtime_error(arguments.fitted + ": has " + std::to_string(places.size()) +
                                 " vertices, the correspondence is from a template of " +
                                 std::to_string(c.from_vertices));
    Mesh(session, carried(c, places), c.triangles).save(session, arguments.out);
    report["out"] = arguments.out;
    return report;
}

const std::vector<std::string>& face_tracking_names() {
    static const std::vector<std::string> kNames{
        "eyeBlinkLeft",      "eyeLookDownLeft",    "eyeLookInLeft",
        "eyeLookOutLeft",    "eyeLookUpLeft",      "eyeSquintLeft",
        "eyeWideLeft",       "eyeBlinkRight",      "eyeLookDownRight",
        "eyeLookInRight",    "eyeLookOutRight",    "eyeLookUpRight",
        "eyeSquintRight",    "eyeWideRight",       "jawForward",
        "jawLeft",           "jawRight",           "jawOpen",
        "mouthClose",        "mouthFunnel",        "mouthPucker",
        "mouthLeft",         "mouthRight",         "mouthSmileLeft",
        "mouthSmileRight",   "mouthFrownLeft",     "mouthFrownRight",
        "mouthDimpleLeft",   "mouthDimpleRight",   "mouthStretchLeft",
        "mouthStretchRight", "mouthRollLower",     "mouthRollUpper",
        "mouthShrugLower",   "mouthShrugUpper",    "mouthPressLeft",
        "mouthPressRight",   "mouthLowerDownLeft", "mouthLowerDownRight",
        "mouthUpperUpLeft",  "mouthUpperUpRight",  "browDownLeft",
        "browDownRight",     "browInnerUp",        "browOuterUpLeft",
        "browOuterUpRight",  "cheekPuff",          "cheekSquintLeft",
        "cheekSquintRight",  "noseSneerLeft",      "noseSneerRight",
        "tongueOut"};
    return kNames;
}

std::vector<std::string> in_tracking_order(const std::vector<std::string>& sources) {
    const auto stem = [](const std::string& path) {
        return std::filesystem::u8path(path).stem().u8string();
    };
    std::vector<std::string> ordered;
    std::string missing;
    for (const std::string& name : face_tracking_names()) {
        const auto source = std::find_if(sources.begin(), sources.end(),
                                         [&](const auto& path) { return stem(path) == name; });
        if (source == sources.end())
            missing += " " + name;
        else
            ordered.push_back(*source);
    }
    if (!missing.empty())
        throw std::runtime_error("--face-tracking: no --source-expression is called" + missing);
    for (const std::string& path : sources)
        if (std::find(ordered.begin(), ordered.end(), path) == ordered.end())
            throw std::runtime_error(path + ": '" + stem(path) +
                                     "' is none of the 52 names of --face-tracking");
    return ordered;
}

}  // namespace mien::cli
