#include "mesh/decimation.hpp"

#include <algorithm>
#include <array>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>

#include "base/error.hpp"
#include "mesh/half_edge.hpp"

namespace mien {
namespace {

/// Of a mesh with twice as many triangles as vertices, measured: 309.
constexpr std::size_t kLeastBytesPerVertex = 280;

/// More neighbours than this make a vertex a hub, which stays where it is and takes part in no
/// collapse: what the decimater asks about a vertex takes the square of its neighbours, and it asks
/// after each collapse beside it.
constexpr unsigned kHubValence = 128;

/// The mesh as the decimater sees it: hubs have no way to collapse, and looking for one costs
/// nothing.
class DecimatedHalfEdges : public HalfEdgeMesh {
  public:
    DecimatedHalfEdges(const TriMesh& mesh, const Context& context) {
        fill_half_edge_mesh(mesh, "the mesh to decimate", *this, context);
        hub_.resize(n_vertices());
        for (const auto v : vertices())
            hub_[static_cast<std::size_t>(v.idx())] = valence(v) > kHubValence;
    }
    bool is_hub(VertexHandle v) const { return hub_[static_cast<std::size_t>(v.idx())]; }

    /// What the decimater walks to find a vertex's best collapse.
    class VertexOHalfedgeIter {
      public:
        VertexOHalfedgeIter(const DecimatedHalfEdges& mesh, VertexHandle v)
            : walk_(mesh, v), none_(mesh.is_hub(v)) {}
        bool is_valid() const { return !none_ && walk_.is_valid(); }
        void operator++() { ++walk_; }
        HalfedgeHandle operator*() const { return *walk_; }

      private:
        HalfEdgeMesh::ConstVertexOHalfedgeIter walk_;
        bool none_;
    };
    bool is_collapse_ok(HalfedgeHandle h) {
        return !is_hub(to_vertex_handle(h)) && !is_hub(from_vertex_handle(h)) &&
               HalfEdgeMesh::is_collapse_ok(h);
    }
    HalfedgeHandle find_halfedge(VertexHandle from, VertexHandle to) const {
        if (!is_hub(from)) return HalfEdgeMesh::find_halfedge(from, to);
        const HalfedgeHandle back = HalfEdgeMesh::find_halfedge(to, from);
        return back.is_valid() ? opposite_halfedge_handle(back) : back;
    }

  private:
    std::vector<bool> hub_;
};

/// Stops the decimater when the call is cancelled, and tells how far it is.
class Watch : public OpenMesh::Decimater::Observer {
  public:
    explicit Watch(const Context& context) : Observer(256), context_(context) {}
    // Between two collapses: an exception here leaves nothing half done.
    void notify(size_t) override { context_.check_cancelled(); }
    bool abort() const override { return false; }

  private:
    const Context& context_;
};

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

/// Decimater::add() forgets the module that it made when there is no memory to list it.
template <typename Decimater, typename Handle>
void add_module(Decimater& decimater, Handle& handle) {
    try {
        decimater.add(handle);
    } catch (...) {
        if (handle.is_valid()) delete &decimater.module(handle);
        throw;
    }
}

}  // namespace

DecimatedMesh decimate(const TriMesh& mesh, Index num_vertices, const Context& context) {
    check_mesh(mesh, "the mesh to decimate");
    if (num_vertices < 4)
        fail(Status::invalid_argument, "decimation to %lld vertices; at least 4 are needed",
             static_cast<long long>(num_vertices));
    context.check_cancelled();
    // Half edges, quadrics and the heap; what more it takes is counted as it is taken.
    context.require_memory(static_cast<std::size_t>(mesh.vertices.rows()) * kLeastBytesPerVertex,
                           "decimation");
    DecimatedHalfEdges half_edges(mesh, context);
    OpenMesh::VPropHandleT<std::uint32_t> original;
    half_edges.add_property(original);
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        half_edges.property(original, half_edges.vertex_handle(static_cast<unsigned>(v))) =
            static_cast<std::uint32_t>(v);
    OpenMesh::Decimater::DecimaterT<DecimatedHalfEdges> decimater(half_edges);
    OpenMesh::Decimater::ModQuadricT<DecimatedHalfEdges>::Handle quadric;
    BorderModule<DecimatedHalfEdges>::Handle border;
    add_module(decimater, quadric);
    add_module(decimater, border);
    decimater.module(quadric).unset_max_err();
    if (!decimater.initialize()) fail(Status::internal, "the decimation modules do not fit");
    Watch watch(context);
    decimater.set_observer(&watch);
    decimater.decimate_to(static_cast<std::size_t>(num_vertices));
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
