#if defined(__GNUC__) && !defined(__clang__)
// OpenMesh fills new properties from a default value that it leaves unset.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "mesh/half_edge.hpp"

#include <mutex>
#include <OpenMesh/Core/System/omstream.hh>

#include "base/error.hpp"
#include "mesh/topology.hpp"

namespace mien {
namespace {

/// What is checked below leaves OpenMesh nothing to complain about, and it shall not print anyway.
void silence_openmesh() {
    static std::once_flag once;
    std::call_once(once, [] {
        omerr().disable();
        omlog().disable();
        omout().disable();
    });
}

void check_manifold(const TriMesh& mesh, const char* what, const Context& context) {
    const Index num_vertices = mesh.vertices.rows();
    const EdgeTable table = build_edge_table(mesh.triangles, num_vertices, context);
    const TopologyReport report = inspect_topology(table, mesh.triangles, num_vertices);
    if (report.num_degenerate_triangles != 0)
        fail_at(Status::invalid_mesh, report.first_degenerate_triangle,
                "%s: triangle %lld has a vertex twice; clean the mesh", what,
                static_cast<long long>(report.first_degenerate_triangle));
    auto fail_edge = [&](std::int64_t edge, const char* why) {
        const auto& ends = table.edges[static_cast<std::size_t>(edge)];
        fail_at(Status::invalid_mesh, ends[0], "%s: the edge between vertices %lu and %lu %s", what,
                static_cast<unsigned long>(ends[0]), static_cast<unsigned long>(ends[1]), why);
    };
    if (report.num_complex_edges != 0)
        fail_edge(report.first_complex_edge, "has more than two triangles; a template is manifold");
    if (report.num_misoriented_edges != 0)
        fail_edge(report.first_misoriented_edge,
                  "has triangles oriented against each other; orient them alike");
    if (report.num_pinched_vertices != 0)
        fail_at(Status::invalid_mesh, report.first_pinched_vertex,
                "%s: the triangles around vertex %lld form more than one fan; split the vertex",
                what, static_cast<long long>(report.first_pinched_vertex));
}

}  // namespace

void fill_half_edge_mesh(const TriMesh& mesh, const char* what, HalfEdgeMesh& half_edges,
                         const Context& context) {
    check_mesh(mesh, what);
    check_manifold(mesh, what, context);
    silence_openmesh();
    const std::size_t num_vertices = static_cast<std::size_t>(mesh.vertices.rows());
    const std::size_t num_triangles = static_cast<std::size_t>(mesh.triangles.rows());
    half_edges.reserve(num_vertices, num_vertices + num_triangles, num_triangles);
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        half_edges.add_vertex({mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2)});
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        const auto corner = [&](int k) {
            return OpenMesh::VertexHandle(static_cast<int>(mesh.triangles(t, k)));
        };
        if (!half_edges.add_face(corner(0), corner(1), corner(2)).is_valid())
            fail_at(Status::invalid_mesh, t, "%s: triangle %lld does not fit its neighbours", what,
                    static_cast<long long>(t));
    }
}

HalfEdgeMesh build_half_edge_mesh(const TriMesh& mesh, const char* what, const Context& context) {
    HalfEdgeMesh half_edges;
    fill_half_edge_mesh(mesh, what, half_edges, context);
    return half_edges;
}

TriMesh from_half_edge_mesh(const HalfEdgeMesh& half_edges) {
    TriMesh mesh;
    mesh.vertices.resize(static_cast<Index>(half_edges.n_vertices()), 3);
    mesh.triangles.resize(static_cast<Index>(half_edges.n_faces()), 3);
    for (const auto vertex : half_edges.vertices()) {
        const auto& point = half_edges.point(vertex);
        mesh.vertices.row(vertex.idx()) << point[0], point[1], point[2];
    }
    for (const auto face : half_edges.faces()) {
        int corner = 0;
        for (auto it = half_edges.cfv_iter(face); it.is_valid(); ++it)
            mesh.triangles(face.idx(), corner++) = static_cast<std::uint32_t>(it->idx());
    }
    return mesh;
}

}  // namespace mien
