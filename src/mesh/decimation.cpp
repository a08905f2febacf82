#include "mesh/decimation.hpp"

#include <algorithm>
#include <array>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "base/error.hpp"
#include "mesh/half_edge.hpp"

namespace mien {
namespace {

/// Borders may shrink along themselves, never be pulled inwards.
template <class MeshT>
class BorderModule : public OpenMesh::Decimater::ModBaseT<MeshT> {
  public:
    DECIMATING_MODULE(BorderModule, MeshT, Border);
    explicit BorderModule(MeshT& mesh) : Base(mesh, true) {}
    float collapse_priority(const CollapseInfo& info) override {
        const MeshT& mesh = Base::mesh();
        const bool inwards = mesh.is_boundary(info.v0) && !mesh.is_boundary(info.v0v1) &&
                             !mesh.is_boundary(info.v1v0);
        return float(inwards ? Base::ILLEGAL_COLLAPSE : Base::LEGAL_COLLAPSE);
    }
};

}  // namespace

DecimatedMesh decimate(const TriMesh& mesh, Index num_vertices, const Context& context) {
    check_mesh(mesh, "the mesh to decimate");
    if (num_vertices < 4)
        fail(Status::invalid_argument, "decimation to %lld vertices; at least 4 are needed",
             static_cast<long long>(num_vertices));
    context.check_cancelled();
    context.require_memory(static_cast<std::size_t>(mesh.vertices.rows()) * 600, "decimation");
    HalfEdgeMesh half_edges = build_half_edge_mesh(mesh, "the mesh to decimate", context);
    OpenMesh::VPropHandleT<std::uint32_t> original;
    half_edges.add_property(original);
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        half_edges.property(original, half_edges.vertex_handle(static_cast<unsigned>(v))) =
            static_cast<std::uint32_t>(v);
    OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater(half_edges);
    OpenMesh::Decimater::ModQuadricT<HalfEdgeMesh>::Handle quadric;
    BorderModule<HalfEdgeMesh>::Handle border;
    decimater.add(quadric);
    decimater.add(border);
    decimater.module(quadric).unset_max_err();
    if (!decimater.initialize()) fail(Status::internal, "the decimation modules do not fit");
    decimater.decimate_to(static_cast<std::size_t>(num_vertices));
    context.check_cancelled();
    half_edges.garbage_collection();

    // Ascending fine indices, whatever order garbage collection left.
    std::vector<std::pair<std::uint32_t, int>> order;
    for (const auto v : half_edges.vertices())
        order.emplace_back(half_edges.property(original, v), v.idx());
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> place(order.size());
    DecimatedMesh result;
    result.mesh.vertices.resize(static_cast<Index>(order.size()), 3);
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[static_cast<std::size_t>(order[i].second)] = static_cast<std::uint32_t>(i);
        result.kept.push_back(order[i].first);
        result.mesh.vertices.row(static_cast<Index>(i)) = mesh.vertices.row(order[i].first);
    }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto f : half_edges.faces()) {
        std::array<std::uint32_t, 3> corners{};
        int k = 0;
        for (const auto v : f.vertices())
            corners[static_cast<std::size_t>(k++)] = place[static_cast<std::size_t>(v.idx())];
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                    corners.end());
        triangles.push_back(corners);
    }
    std::sort(triangles.begin(), triangles.end());
    result.mesh.triangles.resize(static_cast<Index>(triangles.size()), 3);
    for (std::size_t f = 0; f < triangles.size(); ++f)
        for (int k = 0; k < 3; ++k)
            result.mesh.triangles(static_cast<Index>(f), k) =
                triangles[f][static_cast<std::size_t>(k)];
    return result;
}

}  // namespace mien
