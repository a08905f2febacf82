// A smooth field of slides over the template that goes through what was measured of it:
//
//   minimise  sum_v A_v / l^2 (u_v - m_v)' M_v (u_v - m_v) + sum_ij |u_i - u_j|^2 / sqrt(3)
//             + sum_v A_v / g^2 |u_v|^2
//
// A_v the area of a vertex, M_v between 0 and 1: how far the measurement m_v counts in each
// direction. In a plane of even triangles the middle sum is the integral of the field's squared
// gradient, whatever their size, so that l is the length over which measurements are averaged and
// g the one over which the field ends where there are none.
#pragma once

#include "base/context.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct SlideFieldSettings {
    double smooth_mm = 3;       ///< l, mm, > 0 [J]
    double ground_mm = 30;      ///< g, mm, > 0 [J]
    int most_iterations = 200;  ///< >= 1, of conjugate gradients [J]
    double tolerance = 1e-6;    ///< > 0: of the residual, relative [J]
};

/// What holds a vertex: trust M and M m.
struct SlidePull {
    Matrix3 trust = Matrix3::Zero();
    Vector3 pull = Vector3::Zero();
};

/// Of one template.
class SlideField {
  public:
    /// `part`: #V, 1 where there is a field; it is 0 elsewhere, and they are no neighbours.
    SlideField(const TriMesh& template_mesh, const VertexRings& rings,
               const std::vector<std::uint8_t>& part);

    /// Improves `field` (#V x 3, mm), which is also where it begins. O(iterations #V).
    void solve(const std::vector<SlidePull>& pulls, const SlideFieldSettings& settings,
               Points& field, const Context& context) const;

    const Vector& area_mm2() const { return area_; }

  private:
    const VertexRings& rings_;
    const std::vector<std::uint8_t>& part_;
    Vector area_;
};

}  // namespace mien
