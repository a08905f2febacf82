#include "face_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <stdexcept>

namespace mien::cli {
namespace {

/// A closed or open face that looks outwards has a share above 0.5; turned over, below -0.5.
constexpr double kInsideOut = -0.3;
/// Extents in mm between which a mesh may be a face or a part of one; [3, 3000].
constexpr double kLeastExtent_mm = 40, kMostExtent_mm = 3000;
/// Two faces may lie so far apart (root mean square, mm) before their frames are asked for.
constexpr double kOneFrame_mm = 2;
/// Stable zones of one person's fits stay within this (root mean square, mm) once they are aligned;
/// those of 15 pairs of simulated people lay 1.1 to 1.7 mm apart, one person's, expressions and
/// injections among them (445 pairs of visits), at most 0.13.
constexpr double kOnePerson_mm = 0.5;
/// One person's visits differ in size by less than this share; forehead and nose of 14 people
/// scanned again, neutral or smiling, differed by at most 1.1 %, those of others by 3.6 % (median).
constexpr double kOneSize = 0.015;
/// Vertices that a size is told from; [4, inf).
constexpr std::size_t kFewestForSize = 100;
/// Where moving one face explains more than this factor of the difference, the frames differ.
constexpr double kExplained = 3;

nlohmann::json inspected(const Session& session, const NamedFace& face) {
    return nlohmann::json::parse(inspect_mesh(session, face.mesh));
}

/// The triangle as it is wound, from its least vertex on.
Triangle from_least(Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

double rms_apart(const std::vector<Position>& a, const std::vector<Position>& b) {
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
        for (std::size_t k = 0; k < 3; ++k) sum += (a[v][k] - b[v][k]) * (a[v][k] - b[v][k]);
    return a.empty() ? 0 : std::sqrt(sum / static_cast<double>(a.size()));
}

/// Root mean square distance that is left when the second face is moved onto the first, mm.
double rms_moved(const Session& session, const Mesh& onto, const Mesh& moved) {
    std::vector<std::uint32_t> all(onto.vertex_count());
    std::iota(all.begin(), all.end(), 0u);
    mien_zone_alignment info{};
    const Mesh there = align_on_zone(session, moved, onto, all, &info);
    return rms_apart(there.positions(), onto.positions());
}

/// Whether the second face fits the first far better once it is mirrored.
bool is_mirrored(const Session& session, const Mesh& first, const Mesh& second, double left) {
    const std::array<double, 16> mirror{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const double mirrored = rms_moved(session, first, transform_mesh(session, second, mirror));
    return mirrored * kExplained < left;
}

std::string frames_text(const NamedFace& before, const NamedFace& after, double apart,
                        double left) {
    char text[400];
    std::snprintf(text, sizeof text,
                  "%s and %s lie %.1f mm apart, and %.1f mm once the second is moved onto the "
                  "first: they are not in one frame, and what is measured is mostly where they "
                  "lie; align them (measure volume --zones FILE --stable ZONE)",
                  before.path.c_str(), after.path.c_str(), apart, left);
    return text;
}

}  // namespace

void expect_same_triangles(const NamedFace& before, const NamedFace& after) {
    const std::vector<Triangle> a = before.mesh.triangles(), b = after.mesh.triangles();
    const std::string both = before.path + " and " + after.path;
    if (before.mesh.vertex_count() != after.mesh.vertex_count()) return;  // the library says so
    if (a.empty() && b.empty())
        throw std::runtime_error(both + ": have no triangles, so no surface to measure");
    std::size_t same = 0, turned = 0;
    for (std::size_t t = 0; t < std::min(a.size(), b.size()); ++t) {
        const Triangle first = from_least(a[t]), second = from_least(b[t]);
        same += first == second ? 1 : 0;
        turned += first[0] == second[0] && first[1] == second[2] && first[2] == second[1] ? 1 : 0;
    }
    if (a.size() == b.size() && same == a.size()) return;
    if (a.size() == b.size() && turned == a.size())
        throw std::runtime_error(after.path +
                                 ": its triangles are wound the other way than those "
                                 "of " +
                                 before.path + "; mien mesh turn --inside-out turns one of them");
    throw std::runtime_error(
        both + ": have as many vertices, but not the same triangles (" + std::to_string(same) +
        " of " + std::to_string(std::max(a.size(), b.size())) +
        " agree): vertex 1 of one is not vertex 1 of the other. Measure fits of one template, or "
        "two surfaces with --surfaces");
}

void expect_outside_out(const Session& session, const NamedFace& face) {
    if (inspected(session, face)["outward"].get<double>() > kInsideOut) return;
    throw std::runtime_error(face.path +
                             ": its triangles face inwards, so gains would read as losses; turn it "
                             "over first: mien mesh turn " +
                             face.path + " turned.ply --inside-out");
}

void warn_of_unit(const Session& session, const NamedFace& face) {
    const nlohmann::json report = inspected(session, face);
    const double extent = report["extent"];
    const nlohmann::json& units = report["plausible_units"];
    if ((extent >= kLeastExtent_mm && extent <= kMostExtent_mm) || extent == 0 || units.empty())
        return;
    const std::string unit = units[0];
    if (unit == "mm") return;
    std::fprintf(stderr,
                 "mien: warning: %s: its extent is %.4g: by its size it is in %s, but is measured "
                 "as mm; mien mesh scale %s mm.ply --units %s\n",
                 face.path.c_str(), extent, unit.c_str(), face.path.c_str(), unit.c_str());
}

std::vector<std::string> warn_of_frames(const Session& session, const NamedFace& before,
                                        const NamedFace& after, bool aligned) {
    std::vector<std::string> warnings;
    if (before.mesh.vertex_count() != after.mesh.vertex_count() || before.mesh.vertex_count() < 4)
        return warnings;
    const double apart = rms_apart(before.mesh.positions(), after.mesh.positions());
    if (apart == 0) {
        warnings.push_back(before.path + " and " + after.path +
                           ": are the same face, so no change can be measured; is one file named "
                           "twice, or copied?");
    } else if (apart > kOneFrame_mm) {
        const double left = rms_moved(session, before.mesh, after.mesh);
        if (is_mirrored(session, before.mesh, after.mesh, left))
            warnings.push_back(after.path + ": is the mirror image of " + before.path +
                               "; one of them is mirrored (mien mesh turn --mirror x)");
        else if (!aligned && left * kExplained < apart)
            warnings.push_back(frames_text(before, after, apart, left));
    }
    for (const std::string& warning : warnings)
        std::fprintf(stderr, "mien: warning: %s\n", warning.c_str());
    return warnings;
}

double size_ratio(const Mesh& first, const Mesh& second, const std::vector<char>& counts) {
    const auto count = static_cast<std::size_t>(std::count(counts.begin(), counts.end(), 1));
    if (count < kFewestForSize) return 1;
    const auto spread = [&](const std::vector<Position>& places) {
        Position mean{};
        double sum = 0;
        for (std::size_t v = 0; v < places.size(); ++v)
            for (std::size_t k = 0; k < 3 && counts[v] == 1; ++k)
                mean[k] += places[v][k] / static_cast<double>(count);
        for (std::size_t v = 0; v < places.size(); ++v)
            for (std::size_t k = 0; k < 3 && counts[v] == 1; ++k)
                sum += (places[v][k] - mean[k]) * (places[v][k] - mean[k]);
        return std::sqrt(sum);
    };
    const double before = spread(first.positions());
    return before > 0 ? spread(second.positions()) / before : 1;
}

std::vector<std::string> check_visits(const Session& session, const NamedFace& first,
                                      const NamedFace& later, const VisitPair& pair) {
    std::vector<std::string> warnings;
    const std::vector<Position> a = first.mesh.positions(), b = later.mesh.positions();
    if (a.size() != b.size() || a.size() < 4) return warnings;
    char text[400];
    if (a == b) {
        warnings.push_back(later.path + ": is the same face as " + first.path +
                           ", so nothing has changed; is one file there twice?");
    } else {
        const double left = rms_moved(session, first.mesh, later.mesh);
        if (left > kOneFrame_mm && is_mirrored(session, first.mesh, later.mesh, left))
            throw std::runtime_error(later.path + ": is the mirror image of the face in " +
                                     first.path +
                                     "; mirror the scan back (mien mesh turn --mirror x)");
        if (pair.stable_rms_mm > kOnePerson_mm) {
            std::snprintf(text, sizeof text,
                          "the stable zones of %s lie %.1f mm from those of %s once they are "
                          "aligned: is it the same person, and has nothing changed there?",
                          later.path.c_str(), pair.stable_rms_mm, first.path.c_str());
            warnings.emplace_back(text);
        }
        if (std::abs(pair.size_ratio - 1) > kOneSize) {
            std::snprintf(
                text, sizeof text,
                "the face of %s is %.1f %% %s than that of %s by its stable zones: is it the same "
                "person, and are both scans in one unit and calibrated?",
                later.path.c_str(), 100 * std::abs(pair.size_ratio - 1),
                pair.size_ratio > 1 ? "larger" : "smaller", first.path.c_str());
            warnings.emplace_back(text);
        }
    }
    for (const std::string& warning : warnings)
        std::fprintf(stderr, "mien: warning: %s\n", warning.c_str());
    return warnings;
}

}  // namespace mien::cli
