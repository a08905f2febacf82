#include "mesh/mesh_report.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

#include "base/json_text.hpp"
#include "mesh/winding.hpp"

namespace mien {
namespace {

void add_fault(MeshReport& report, const char* format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;
void add_fault(MeshReport& report, const char* format, ...) {
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    report.faults.emplace_back(text);
}

double length_of(const TriMesh& mesh, const std::vector<std::uint32_t>& loop) {
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        length +=
            (mesh.vertices.row(loop[i]) - mesh.vertices.row(loop[(i + 1) % loop.size()])).norm();
    return length;
}

void measure_topology(const TriMesh& mesh, MeshReport& report, const Context& context) {
    const EdgeTable table = build_edge_table(mesh.triangles, mesh.vertices.rows(), context);
    report.topology = inspect_topology(table, mesh.triangles, mesh.vertices.rows());
    for (const auto& loop : border_loops(table, mesh.triangles, mesh.vertices.rows())) {
        ++report.num_border_loops;
        report.longest_border = std::max(report.longest_border, length_of(mesh, loop));
    }
    double sum = 0;
    for (const auto& edge : table.edges)
        sum += (mesh.vertices.row(edge[0]) - mesh.vertices.row(edge[1])).norm();
    if (table.num_edges() > 0) report.mean_edge = sum / static_cast<double>(table.num_edges());
    const ConnectedComponents pieces = connected_components(mesh.triangles, mesh.vertices.rows());
    for (const Index count : pieces.num_triangles) {
        report.num_components += count > 0;
        report.largest_component = std::max(report.largest_component, count);
    }
}

void name_faults(MeshReport& report) {
    const TopologyReport& t = report.topology;
    const auto count = [](Index n) { return static_cast<long long>(n); };
    if (report.units.empty())
        add_fault(report,
                  "an extent of %.4g fits no face, head or body in mm, cm, in, dm, ft, m or km: "
                  "mien mesh scale",
                  report.extent);
    else if (report.units[0].to_mm != 1)
        add_fault(report, "by its extent of %.4g it seems to be in %s: mien mesh scale --units %s",
                  report.extent, report.units[0].name, report.units[0].name);
    if (report.num_triangles == 0) {
        add_fault(report, "it has no triangles: a cloud of points");
        return;
    }
    if (report.num_equal_vertices > 0)
        add_fault(report, "%lld vertices repeat another one's place: mien mesh clean",
                  count(report.num_equal_vertices));
    if (report.num_duplicate_triangles > 0)
        add_fault(report, "%lld triangles are there twice: mien mesh clean",
                  count(report.num_duplicate_triangles));
    if (t.num_degenerate_triangles > 0)
        add_fault(report, "%lld triangles use a vertex twice: mien mesh clean",
                  count(t.num_degenerate_triangles));
    if (t.num_unused_vertices > 0)
        add_fault(report, "%lld vertices belong to no triangle: mien mesh clean",
                  count(t.num_unused_vertices));
    if (t.num_complex_edges > 0)
        add_fault(report, "%lld edges have three triangles or more", count(t.num_complex_edges));
    if (report.num_turned > 0)
        add_fault(report, "%lld triangles are wound against the others: mien mesh clean",
                  count(report.num_turned));
    if (report.outward < -0.3)
        add_fault(report,
                  "its triangles face inwards: it is inside out (mien mesh turn --inside-out) or "
                  "mirrored (mien mesh turn --mirror x)");
    if (report.num_components > 1 && report.largest_component < report.num_triangles * 99 / 100)
        add_fault(report,
                  "it is in %lld pieces: mien mesh clean --min-triangles N drops small ones",
                  count(report.num_components));
}

}  // namespace

MeshReport inspect_mesh(const TriMesh& mesh, const Context& context) {
    MeshReport report;
    report.num_vertices = mesh.vertices.rows();
    report.num_triangles = mesh.triangles.rows();
    report.num_texture = mesh.texture.rows();
    report.has_colors = mesh.colors.rows() > 0;
    report.low = mesh.vertices.colwise().minCoeff().transpose();
    report.high = mesh.vertices.colwise().maxCoeff().transpose();
    report.extent = robust_extent(mesh.vertices);
    report.units = plausible_units(report.extent);
    const CleanedMesh cleaned = clean_mesh(mesh, CleaningOptions(), context);
    report.num_equal_vertices = cleaned.num_merged;
    report.num_duplicate_triangles = cleaned.num_duplicate;
    // Seams of the texture split vertices, which is no border of the surface.
    measure_topology(cleaned.mesh, report, context);
    report.topology.num_unused_vertices = cleaned.num_unused;
    report.topology.num_degenerate_triangles = cleaned.num_degenerate;
    TriMesh consistent = cleaned.mesh;
    const WindingReport winding = make_windings_consistent(consistent, WindingSettings(), context);
    report.num_turned = static_cast<Index>(winding.turned.size());
    report.outward = winding.outward;
    name_faults(report);
    return report;
}

std::string mesh_report_json(const MeshReport& report) {
    JsonText json;
    const TopologyReport& t = report.topology;
    json.begin_object()
        .field("vertices", report.num_vertices)
        .field("triangles", report.num_triangles)
        .field("colors", report.has_colors)
        .field("texture_coordinates", report.num_texture)
        .field("low", report.low)
        .field("high", report.high)
        .field("extent", report.extent)
        .field("mean_edge", report.mean_edge);
    json.key("plausible_units").begin_array();
    for (const LengthUnit& unit : report.units) json.string(unit.name);
    json.end_array()
        .field("components", report.num_components)
        .field("largest_component_triangles", report.largest_component)
        .field("border_loops", report.num_border_loops)
        .field("border_edges", t.num_border_edges)
        .field("longest_border", report.longest_border)
        .field("complex_edges", t.num_complex_edges)
        .field("pinched_vertices", t.num_pinched_vertices)
        .field("degenerate_triangles", t.num_degenerate_triangles)
        .field("duplicate_triangles", report.num_duplicate_triangles)
        .field("unused_vertices", t.num_unused_vertices)
        .field("equal_vertices", report.num_equal_vertices)
        .field("turned_triangles", report.num_turned)
        .field("outward", report.outward)
        .field("faults", report.faults);
    return json.end_object().take();
}

}  // namespace mien
