// What registration asks of a scan: its search tree, normals that outlast the scanner's noise, how
// the surface bends, the border where it simply ends, and per vertex a weight and colours.
//
// Normals and bending are means over neighbours: k rounds of averaging over the triangles around a
// vertex spread a value over about sqrt(k) edges, so k = (smoothing_mm / spacing_mm)^2.
#pragma once

#include <vector>

#include "base/context.hpp"
#include "mesh/image_sampler.hpp"
#include "mesh/tri_mesh.hpp"
#include "mesh/triangle_fans.hpp"
#include "registration/color_signals.hpp"
#include "registration/skin.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {

/// Tags in brackets say what chose a number; registration/settings.hpp lists them.
struct ScanSurfaceSettings {
    double smoothing_mm = 2;       ///< mm, >= 0: reach of the averaged normals and bending [J]
    int most_normal_rounds = 16;   ///< 0 to 1000: bounds the cost on very fine scans [J]
    int most_bending_rounds = 24;  ///< 0 to 1000 [J]
    // Clouds of points
    Index spacing_sample = 150;  ///< >= 1: points whose nearest neighbour gives the spacing [J]
    double normal_spacings = 2;  ///< > 0: least radius of a normal, in spacings [J]
    int most_neighbours = 200;   ///< >= 4: points of a cell that a normal looks at [J]
    int fewest_neighbours = 4;   ///< 3 to most_neighbours: fewer give no normal [J]
};

/// A scan's texture images and how they are looked at where the surface is hit.
struct ScanImages {
    ImageSampler sampler;  ///< of the scan's triangles, mm; perhaps empty
    double radius_mm = 0;  ///< mm, the disc whose mean a look takes
    ColorSignalSettings signals;
    bool weighs_skin = false;  ///< a hit's weight is times its colour's probability of skin
    Vector given_weight;       ///< #V, the host's part of ScanSurface::weight, or empty
    SkinSettings skin;

    bool cover(const SurfaceHit& hit) const { return sampler.covers(hit.triangle); }
};

/// Immutable once built; safe to share between threads and fits. A fit sees it through a ScanView,
/// which knows the side that faces out.
struct ScanSurface {
    Points vertices;      ///< mm, scan frame
    Triangles triangles;  ///< empty for a cloud of points
    TriangleTree tree;
    Points normals;                       ///< #V x 3 unit, averaged; zero where unknown
    std::vector<std::uint8_t> on_border;  ///< #V
    /// #V x 6, the shape operator S (xx yy zz xy xz yz, 1/mm): the normal turns by S p when one
    /// moves by p along the surface. Empty for a cloud.
    Eigen::Matrix<float, Eigen::Dynamic, 6, Eigen::RowMajor> bending;
    double spacing_mm = 0;  ///< mean edge length
    Vector weight;          ///< #V in [0, 1] or empty: all one
    ColorSignals colors;    ///< #V x 2 or empty (color_signals.hpp)
    ScanImages images;      ///< take the place of the vertices' colours where they cover

    bool has_colors() const { return colors.rows() > 0; }
    /// Interpolated normal, unit or zero.
    Vector3 normal_at(const SurfaceHit& hit) const;
    /// Interpolated shape operator; zero for a cloud.
    Matrix3 bending_at(const SurfaceHit& hit) const;
    /// Interpolated weight; 1 where no weights were given. Times the skin's of the images.
    double weight_at(const SurfaceHit& hit) const;
    /// Redness and darkness at the hit, from the image where one covers it, else between the
    /// vertices; the scan must have colours. The one place that looks a colour up.
    Eigen::Vector2d colors_at(const SurfaceHit& hit) const;
    /// True when the hit lies on a border edge or border vertex: the scan goes no further there.
    bool at_border(const SurfaceHit& hit) const;
    /// 0 on the border, 1 from the next row of vertices on, linear between: continuous along the
    /// surface.
    double off_border(const SurfaceHit& hit) const;
};

/// `mesh` must have passed check_mesh(). Leaves `weight` and `colors` empty. O(V + F log F).
ScanSurface build_scan_surface(const TriMesh& mesh, const ScanSurfaceSettings& settings,
                               const Context& context);
/// The same of what the caller gives away, with the fans of the triangles.
ScanSurface build_scan_surface(Points&& vertices, Triangles&& triangles, const TriangleFans& fans,
                               const ScanSurfaceSettings& settings, const Context& context);

/// A scan as one fit sees it. Triangles may face inwards, which the start finds out: then normals
/// and bending are those of the other side. Borrows the surface; cheap to copy.
class ScanView {
  public:
    ScanView(const ScanSurface& surface) : surface_(&surface) {}  // NOLINT: meant to convert

    const ScanSurface& surface() const { return *surface_; }
    const TriangleTree& tree() const { return surface_->tree; }
    bool turned_over() const { return side_ < 0; }
    /// Swaps inside and outside.
    void turn_over() { side_ = -side_; }

    Vector3 normal_at(const SurfaceHit& hit) const { return side_ * surface_->normal_at(hit); }
    Matrix3 bending_at(const SurfaceHit& hit) const { return side_ * surface_->bending_at(hit); }
    Eigen::RowVector3d vertex_normal(Index vertex) const {
        return side_ * surface_->normals.row(vertex);
    }

  private:
    const ScanSurface* surface_;
    double side_ = 1;
};

}  // namespace mien
