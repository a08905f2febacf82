// An adaptive triangle mesh of an implicit surface: marching tetrahedra give a start, then edges
// are split, collapsed, flipped and relaxed until they have the length that a size field asks for
// (Botsch and Kobbelt, "A remeshing approach to multiresolution modeling", SGP 2004), each vertex
// being drawn back to the surface and to the curves it belongs to by Newton steps of least length.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "numbers.hpp"

namespace mien::demo {

/// A field whose zero set a vertex stays on.
struct Constraint {
    std::function<double(V3)> value;
    std::function<V3(V3)> gradient;
};

class SurfaceMesher {
  public:
    static constexpr unsigned kPinned = 1u << 31;  ///< never moved or removed

    /// `surface` always holds; curve k holds for vertices whose flags contain bit k.
    SurfaceMesher(Constraint surface, std::vector<Constraint> curves,
                  std::function<double(V3)> size_mm)
        : surface_(std::move(surface)), curves_(std::move(curves)), size_(std::move(size_mm)) {}

    /// Cells of `step` mm over the box low..high; what leaves the box is cut off there.
    void march(V3 low, V3 high, double step);
    /// Border vertices for which `on_curve` holds get the flag.
    void flag_border(unsigned flag, const std::function<bool(V3)>& on_curve);
    void remesh(int rounds, bool delaunay);

    /// Splits every edge on which `field` changes sign inside `where`, snapping vertices close to
    /// the zero set onto it; vertices on the zero set get `flag` (a bit of a curve).
    void insert_curve(unsigned flag, const std::function<double(V3)>& field,
                      const std::function<bool(V3)>& where);
    /// Removes triangles whose corners all satisfy `inside` (corners with `flag` count as inside).
    void remove_inside(unsigned flag, const std::function<bool(V3)>& inside);
    /// Opens the mesh along the edges between vertices of `flag`: triangles on the negative side of
    /// `field` get copies flagged `below` instead of `flag`; vertex `tip` stays single.
    void cut(unsigned flag, unsigned below, const std::function<double(V3)>& field, int tip);

    int nearest(V3 p) const;
    int nearest(V3 p, unsigned flag) const;
    void pin(int vertex, V3 position, unsigned flags);
    V3 project(V3 p, unsigned flags, int steps = 8) const;
    void project_all();
    void compact();

    std::vector<V3> points;
    std::vector<unsigned> flags;
    std::vector<std::array<int, 3>> triangles;

  private:
    using Edge = std::array<int, 2>;
    void build_fans();
    std::vector<Edge> edges() const;
    int edge_triangles(int a, int b, int out[2]) const;
    bool on_border(int vertex) const;
    std::vector<int> neighbours(int vertex) const;
    int split(int a, int b, V3 at);
    bool collapse(int gone, int kept, double longest);
    void split_long();
    void collapse_short();
    void collapse_caps();
    void flip(bool delaunay);
    void relax();
    void drop(int triangle);

    Constraint surface_;
    std::vector<Constraint> curves_;
    std::function<double(V3)> size_;
    std::vector<std::vector<int>> fan_;  // triangles around each vertex
    std::vector<char> border_;
};

}  // namespace mien::demo
