#include "model/template_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <Eigen/Geometry>
#include <set>

#include "base/error.hpp"
#include "base/json_text.hpp"
#include "mesh/length_unit.hpp"
#include "mesh/topology.hpp"
#include "mesh/weld.hpp"
#include "mesh/winding.hpp"

namespace mien {
namespace {

using Findings = std::vector<TemplateFinding>;

std::string format_text(const char* format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 1, 2)))
#endif
    ;
std::string format_text(const char* format, ...) {
    char text[400];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return text;
}

std::vector<std::uint32_t> sorted_unique(std::vector<std::uint32_t> vertices) {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

std::vector<std::uint32_t> corners_of(const TriMesh& mesh,
                                      const std::vector<std::uint32_t>& triangles) {
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t t : triangles)
        for (int k = 0; k < 3; ++k) vertices.push_back(mesh.triangles(t, k));
    return sorted_unique(std::move(vertices));
}

/// "vertices 3, 17, 20 and 5 more"
std::string first_of(const std::vector<std::uint32_t>& vertices) {
    constexpr std::size_t kShown = 3;
    std::string text = vertices.size() == 1 ? "vertex " : "vertices ";
    for (std::size_t i = 0; i < std::min(kShown, vertices.size()); ++i)
        text += (i > 0 ? ", " : "") + std::to_string(vertices[i]);
    if (vertices.size() > kShown)
        text += " and " + std::to_string(vertices.size() - kShown) + " more";
    return text;
}

void check_size(const TriMesh& mesh, const TemplateCheckOptions& o, Findings& findings) {
    const double extent = robust_extent(mesh.vertices);
    if (extent >= o.face_mm && extent <= o.bust_mm) return;
    std::string guesses;
    bool body = false;
    for (const LengthUnit& unit : plausible_units(extent)) {
        const double size_mm = extent * unit.to_mm;
        body = body || size_mm > o.bust_mm;
        guesses += (guesses.empty() ? "" : " or ") +
                   format_text("%s in %s (%.0f mm)",
                               size_mm > o.bust_mm ? "a whole body" : "a face or head", unit.name,
                               size_mm);
    }
    const char* cure = body ? "cut the head out and bring it to mm (mien mesh scale)"
                            : "bring it to mm (mien mesh scale)";
    findings.push_back(
        {FindingKind::error,
         "unit",
         format_text("its extent of %.4g is no face, head or bust in mm (%g to %g): "
                     "%s; %s",
                     extent, o.face_mm, o.bust_mm,
                     guesses.empty() ? "nor in any other unit" : guesses.c_str(), cure),
         {}});
}

void check_windings(const TriMesh& mesh, const TemplateCheckOptions& o, const Context& context,
                    Findings& findings) {
    TriMesh copy = mesh;
    const WindingReport report = make_windings_consistent(copy, WindingSettings(), context);
    if (!report.turned.empty()) {
        const std::vector<std::uint32_t> vertices = corners_of(mesh, report.turned);
        findings.push_back({FindingKind::error, "winding",
                            format_text("%zu triangles are wound against the others (%s): volumes "
                                        "would have the wrong sign there; mien mesh clean",
                                        report.turned.size(), first_of(vertices).c_str()),
                            vertices});
    }
    if (report.outward < o.inwards)
        findings.push_back(
            {FindingKind::error,
             "inside-out",
             "its triangles face inwards: every volume would have the wrong sign; it is inside out "
             "(mien mesh turn --inside-out) or mirrored (mien mesh turn --mirror x)",
             {}});
    if (report.num_impossible_edges > 0)
        findings.push_back({FindingKind::warning,
                            "one-sided",
                            format_text("at %lld edges no winding is right (a Moebius band)",
                                        static_cast<long long>(report.num_impossible_edges)),
                            {}});
}

void check_pieces(const TriMesh& mesh, const TemplateCheckOptions& o, Findings& findings) {
    const ConnectedComponents pieces = connected_components(mesh.triangles, mesh.vertices.rows());
    std::vector<std::uint32_t> helpers, others, unused;
    Index num_helpers = 0, num_others = 0;
    for (std::size_t p = 1; p < pieces.num_triangles.size(); ++p) {
        const Index count = pieces.num_triangles[p];
        num_helpers += count > 0 && count <= o.helper_triangles;
        num_others += count > o.helper_triangles;
    }
    for (std::size_t v = 0; v < pieces.of_vertex.size(); ++v) {
        const std::uint32_t p = pieces.of_vertex[v];
        if (pieces.num_triangles[p] == 0)
            unused.push_back(static_cast<std::uint32_t>(v));
        else if (p > 0)
            (pieces.num_triangles[p] <= o.helper_triangles ? helpers : others)
                .push_back(static_cast<std::uint32_t>(v));
    }
    if (num_helpers > 0)
        findings.push_back(
            {FindingKind::warning, "helpers",
             format_text("%lld pieces of at most %lld triangles beside the face (%s): "
                         "helpers of a modelling program? mien mesh clean "
                         "--min-triangles %lld",
                         static_cast<long long>(num_helpers),
                         static_cast<long long>(o.helper_triangles), first_of(helpers).c_str(),
                         static_cast<long long>(o.helper_triangles) + 1),
             helpers});
    if (num_others > 0)
        findings.push_back(
            {FindingKind::warning, "pieces",
             format_text("%lld more pieces beside the largest (%s): eyeballs, teeth "
                         "or clothes are no skin and would be fitted to it",
                         static_cast<long long>(num_others), first_of(others).c_str()),
             others});
    if (!unused.empty())
        findings.push_back({FindingKind::warning, "unused",
                            format_text("%zu vertices belong to no triangle (%s); mien mesh clean",
                                        unused.size(), first_of(unused).c_str()),
                            unused});
}

void check_triangles(const TriMesh& mesh, const TemplateCheckOptions& o, const Context& context,
                     Findings& findings) {
    std::vector<std::uint32_t> twice, needles;
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        const auto row = mesh.triangles.row(t);
        if (row[0] == row[1] || row[1] == row[2] || row[0] == row[2]) {
            twice.push_back(static_cast<std::uint32_t>(t));
            continue;
        }
        const Vector3 a = mesh.vertices.row(row[0]), b = mesh.vertices.row(row[1]),
                      c = mesh.vertices.row(row[2]);
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        if (!((b - a).cross(c - a).norm() / 2 > o.needle * longest * longest))
            needles.push_back(static_cast<std::uint32_t>(t));
    }
    const auto report = [&](const char* code, FindingKind kind, const char* what,
                            const std::vector<std::uint32_t>& triangles) {
        if (triangles.empty()) return;
        const std::vector<std::uint32_t> vertices = corners_of(mesh, triangles);
        findings.push_back({kind, code,
                            format_text("%zu triangles %s (%s); mien mesh clean", triangles.size(),
                                        what, first_of(vertices).c_str()),
                            vertices});
    };
    report("degenerate", FindingKind::error, "use a vertex twice", twice);
    report("needles", FindingKind::warning, "have next to no area", needles);
    const WeldedPoints welded = weld_points(mesh.vertices, context);
    std::vector<std::uint32_t> doubled;
    for (std::size_t v = 0; v < welded.class_of.size(); ++v)
        if (welded.first_point[welded.class_of[v]] != v)
            doubled.push_back(static_cast<std::uint32_t>(v));
    if (!doubled.empty())
        findings.push_back({FindingKind::warning, "seams",
                            format_text("%zu vertices repeat another one's place (%s): the surface "
                                        "is cut there, so a kernel along it stops; mien mesh clean",
                                        doubled.size(), first_of(doubled).c_str()),
                            doubled});
    const EdgeTable table = build_edge_table(mesh.triangles, mesh.vertices.rows(), context);
    const TopologyReport topology = inspect_topology(table, mesh.triangles, mesh.vertices.rows());
    if (topology.num_complex_edges > 0) {
        std::vector<std::uint32_t> vertices;
        for (std::size_t e = 0; e < table.num_edges(); ++e)
            if (table.num_sides(e) > 2)
                vertices.insert(vertices.end(), table.edges[e].begin(), table.edges[e].end());
        vertices = sorted_unique(std::move(vertices));
        findings.push_back({FindingKind::warning, "edges",
                            format_text("%lld edges have three triangles or more (%s)",
                                        static_cast<long long>(topology.num_complex_edges),
                                        first_of(vertices).c_str()),
                            vertices});
    }
}

/// Middle of the landmarks whose names begin so; false when there are fewer than three.
bool middle_of(const TriMesh& mesh, const std::vector<Landmark>& landmarks, const char* prefix,
               Vector3& middle, std::vector<std::uint32_t>* vertices = nullptr) {
    middle.setZero();
    Index count = 0;
    for (const Landmark& landmark : landmarks)
        if (landmark.name.compare(0, std::string(prefix).size(), prefix) == 0) {
            middle += mesh.vertices.row(landmark.vertex).transpose();
            if (vertices != nullptr) vertices->push_back(landmark.vertex);
            ++count;
        }
    if (count > 0) middle /= static_cast<double>(count);
    return count >= 3;
}

void check_pose(const TriMesh& mesh, const TemplateCheckOptions& o, Findings& findings) {
    Vector3 left, right, mouth, bridge;
    if (!middle_of(mesh, o.landmarks, "eye_left", left) ||
        !middle_of(mesh, o.landmarks, "eye_right", right) ||
        !middle_of(mesh, o.landmarks, "mouth_outer", mouth))
        return;
    const Vector3 across = left - right, up = (left + right) / 2 - mouth;
    if (across[0] < 0)
        findings.push_back({FindingKind::error,
                            "left-right",
                            "the landmarks eye_left_* lie on the side of -x, the subject's right: "
                            "left and right are exchanged, or the template is mirrored",
                            {}});
    const Vector3 front = across.cross(up);
    if (!(up[1] > 0.7 * up.norm()) || !(std::abs(front[2]) > 0.5 * front.norm()))
        findings.push_back(
            {FindingKind::error,
             "pose",
             format_text("it does not stand upright and look along +z (eyes lie %.2f "
                         "%.2f %.2f from the mouth): turn it so that +y is up and +z "
                         "comes out of the face (mien mesh turn)",
                         up[0], up[1], up[2]),
             {}});
    if (middle_of(mesh, o.landmarks, "nose_base", bridge) &&
        !((bridge - (left + right + mouth) / 3)[2] > 0))
        findings.push_back(
            {FindingKind::error,
             "pose",
             "its nose lies behind its eyes and mouth: it looks along -z; turn it so "
             "that +z comes out of the face (mien mesh turn --rotate 0,180,0)",
             {}});
}

void check_openings(const TriMesh& mesh, const TemplateCheckOptions& o, const Context& context,
                    Findings& findings) {
    const EdgeTable table = build_edge_table(mesh.triangles, mesh.vertices.rows(), context);
    const auto loops = border_loops(table, mesh.triangles, mesh.vertices.rows());
    struct Opening {
        const char *prefix, *what;
    };
    for (const Opening& opening :
         {Opening{"eye_left", "left eye"}, Opening{"eye_right", "right eye"},
          Opening{"mouth_inner", "mouth"}}) {
        Vector3 middle;
        std::vector<std::uint32_t> ring;
        if (!middle_of(mesh, o.landmarks, opening.prefix, middle, &ring)) continue;
        double wide_mm = 0;
        for (const std::uint32_t v : ring)
            wide_mm = std::max(wide_mm, (mesh.vertices.row(v).transpose() - middle).norm());
        bool open = false;
        for (const auto& loop : loops) {
            Vector3 centre = Vector3::Zero();
            for (const std::uint32_t v : loop) centre += mesh.vertices.row(v).transpose();
            centre /= static_cast<double>(loop.size());
            double radius_mm = 0;
            for (const std::uint32_t v : loop)
                radius_mm = std::max(radius_mm, (mesh.vertices.row(v).transpose() - centre).norm());
            open = open ||
                   ((centre - middle).norm() < o.opening_mm && radius_mm < wide_mm + o.opening_mm);
        }
        if (!open)
            findings.push_back(
                {FindingKind::warning, "closed",
                 format_text(
                     "the %s is closed: what closes it (a bag, a socket, a lid) is not seen "
                     "on scans; it is carried along, and zones should leave it out",
                     opening.what),
                 sorted_unique(ring)});
    }
}

void check_symmetry(const TriMesh& mesh, Findings& findings) {
    const Index n = mesh.vertices.rows();
    double sum = 0;
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            sum += (mesh.vertices.row(mesh.triangles(t, k)) -
                    mesh.vertices.row(mesh.triangles(t, (k + 1) % 3)))
                       .norm();
    const double reach =
        sum / std::max<double>(1.0, 3.0 * static_cast<double>(mesh.triangles.rows()));
    // Sorted along y: only vertices within reach of an image are looked at.
    std::vector<std::uint32_t> by_y(static_cast<std::size_t>(n));
    for (std::size_t v = 0; v < by_y.size(); ++v) by_y[v] = static_cast<std::uint32_t>(v);
    const auto y_of = [&](std::uint32_t v) { return mesh.vertices(v, 1); };
    std::sort(by_y.begin(), by_y.end(),
              [&](std::uint32_t a, std::uint32_t b) { return y_of(a) < y_of(b); });
    std::vector<std::uint32_t> alone;
    for (Index v = 0; v < n; ++v) {
        const Eigen::RowVector3d image(-mesh.vertices(v, 0), mesh.vertices(v, 1),
                                       mesh.vertices(v, 2));
        bool found = false;
        for (auto at = std::lower_bound(by_y.begin(), by_y.end(), image[1] - reach,
                                        [&](std::uint32_t a, double y) { return y_of(a) < y; });
             !found && at != by_y.end() && y_of(*at) <= image[1] + reach; ++at)
            found = (mesh.vertices.row(*at) - image).squaredNorm() < reach * reach;
        if (!found) alone.push_back(static_cast<std::uint32_t>(v));
    }
    if (!alone.empty())
        findings.push_back({FindingKind::error, "symmetry",
                            format_text("%zu vertices have no partner within %.3g mm of their "
                                        "mirror image (%s): build without --mirror, or mend the "
                                        "template",
                                        alone.size(), reach, first_of(alone).c_str()),
                            alone});
}

}  // namespace

std::vector<TemplateFinding> check_template(const TriMesh& mesh,
                                            const TemplateCheckOptions& options,
                                            const Context& context) {
    for (const Landmark& landmark : options.landmarks)
        if (landmark.vertex >= static_cast<std::uint64_t>(mesh.vertices.rows()))
            fail(Status::invalid_argument,
                 "the landmark '%.60s' is vertex %u, the template has %lld vertices",
                 landmark.name.c_str(), landmark.vertex,
                 static_cast<long long>(mesh.vertices.rows()));
    Findings findings;
    check_size(mesh, options, findings);
    if (mesh.triangles.rows() == 0) {
        findings.push_back({FindingKind::error,
                            "cloud",
                            "it has no triangles: kernels along the surface need them",
                            {}});
        return findings;
    }
    check_windings(mesh, options, context, findings);
    context.check_cancelled();
    check_pieces(mesh, options, findings);
    check_triangles(mesh, options, context, findings);
    context.check_cancelled();
    check_pose(mesh, options, findings);
    check_openings(mesh, options, context, findings);
    if (options.mirror) check_symmetry(mesh, findings);
    std::stable_sort(findings.begin(), findings.end(),
                     [](const TemplateFinding& a, const TemplateFinding& b) {
                         return a.kind == FindingKind::error && b.kind != FindingKind::error;
                     });
    return findings;
}

std::string template_findings_json(const std::vector<TemplateFinding>& findings) {
    std::int64_t errors = 0;
    for (const TemplateFinding& finding : findings) errors += finding.kind == FindingKind::error;
    JsonText json;
    json.begin_object()
        .field("errors", errors)
        .field("warnings", static_cast<std::int64_t>(findings.size()) - errors)
        .key("findings")
        .begin_array();
    for (const TemplateFinding& finding : findings)
        json.begin_object()
            .field("kind", finding.kind == FindingKind::error ? "error" : "warning")
            .field("code", finding.code)
            .field("text", finding.text)
            .field("vertices", finding.vertices)
            .end_object();
    return json.end_array().end_object().take();
}

}  // namespace mien
