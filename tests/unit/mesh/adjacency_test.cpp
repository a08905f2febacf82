#include "mesh/adjacency.hpp"

#include <gtest/gtest.h>
#include <limits>

#include "mesh/shortest_paths.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {
namespace {

std::vector<std::uint32_t> list(VertexSpan span) {
    return {span.begin(), span.end()};
}

// 0 - 1 - 2
// | / | / |    and a loose vertex 6
// 3 - 4 - 5
TriMesh strip() {
    TriMesh mesh;
    mesh.vertices.resize(7, 3);
    mesh.vertices << 0, 1, 0, 1, 1, 0, 2, 1, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 9, 9, 9;
    mesh.triangles.resize(4, 3);
    mesh.triangles << 0, 3, 1, 1, 3, 4, 1, 4, 2, 2, 4, 5;
    return mesh;
}

TEST(Adjacency, EveryNeighbourStandsOnceAscending) {
    const TriMesh mesh = strip();
    const VertexRings rings = build_rings(7, mesh.triangles);
    EXPECT_EQ(rings.num_vertices(), 7);
    EXPECT_EQ(list(rings.of(1)), (std::vector<std::uint32_t>{0, 2, 3, 4}));
    EXPECT_EQ(list(rings.of(5)), (std::vector<std::uint32_t>{2, 4}));
    EXPECT_EQ(rings.of(6).size(), 0u);
}

TEST(Adjacency, ACollapsedTriangleMakesNoVertexItsOwnNeighbour) {
    Triangles triangles(2, 3);
    triangles << 0, 0, 1, 2, 2, 2;
    const VertexRings rings = build_rings(3, triangles);
    EXPECT_EQ(list(rings.of(0)), (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(list(rings.of(1)), (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(rings.of(2).size(), 0u);
}

TEST(Adjacency, EmptyMeshesHaveEmptyRings) {
    EXPECT_EQ(build_rings(0, Triangles(0, 3)).num_vertices(), 0);
    EXPECT_EQ(build_rings(2, Triangles(0, 3)).of(1).size(), 0u);
}

TEST(Adjacency, IncidentTrianglesAscend) {
    const IncidentTriangles incident = incident_triangles(7, strip().triangles);
    EXPECT_EQ(list(incident.of(1)), (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(list(incident.of(5)), (std::vector<std::uint32_t>{3}));
    EXPECT_EQ(incident.of(6).size(), 0u);
}

TEST(Adjacency, AWalkerFindsVerticesByTheirNumberOfEdges) {
    const VertexRings rings = build_rings(7, strip().triangles);
    RingWalker walker(rings);
    EXPECT_EQ(walker.within(0, 0), (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(walker.within(0, 1), (std::vector<std::uint32_t>{0, 1, 3}));
    EXPECT_EQ(walker.within(0, 9).size(), 6u);
    EXPECT_EQ(walker.within(6, 9), (std::vector<std::uint32_t>{6}));
}

TEST(ShortestPaths, DistancesRunAlongEdgesAndNameTheirSource) {
    const TriMesh mesh = strip();
    const PathGraph graph = build_path_graph(mesh.vertices, build_rings(7, mesh.triangles));
    const double far = std::numeric_limits<double>::infinity();
    std::vector<double> distance(7, far);
    std::vector<std::uint32_t> order, source(7, 99);
    walk_paths(graph, {0, 5}, far, distance, [&](const ReachedVertex& at) {
        order.push_back(at.vertex);
        source[at.vertex] = at.source;
        EXPECT_EQ(at.path, distance[at.vertex]);
    });
    EXPECT_EQ(order, (std::vector<std::uint32_t>{0, 5, 1, 2, 3, 4}));
    EXPECT_EQ(distance, (std::vector<double>{0, 1, 1, 1, 1, 0, far}));
    EXPECT_EQ(source, (std::vector<std::uint32_t>{0, 0, 5, 0, 5, 5, 99}));
}

TEST(ShortestPaths, ALimitAndEarlierDistancesEndTheWalk) {
    const TriMesh mesh = strip();
    const PathGraph graph = build_path_graph(mesh.vertices, build_rings(7, mesh.triangles));
    const double far = std::numeric_limits<double>::infinity();
    std::vector<double> distance(7, far);
    int visits = 0;
    walk_paths(graph, {3}, 1.0, distance, [&](const ReachedVertex&) { ++visits; });
    EXPECT_EQ(visits, 3);  // 3, 0 and 4; 1 lies behind a diagonal
    EXPECT_EQ(distance[1], far);
    // A second source changes only what it is nearer to.
    visits = 0;
    walk_paths(graph, {5}, far, distance, [&](const ReachedVertex&) { ++visits; });
    EXPECT_EQ(visits, 3);  // 5, 2 and 1
    EXPECT_EQ(distance[4], 1);
    EXPECT_EQ(distance[1], 2);
}

}  // namespace
}  // namespace mien
