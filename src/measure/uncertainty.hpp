// How sure a signed volume is, to first order, from how sure the two surfaces are.
//
// A surface that lies e_i too far out at vertex i changes the volume by a_i e_i, a_i being the
// vertex' share of the zone's area. Three sources are added:
//   1. noise of each fit: e_i has the deviation s_i and is correlated over the skin,
//      corr(e_i, e_j) = exp(-|x_i - x_j|^2 / (2 l^2)). Independent errors (l -> 0) would average
//      out over thousands of vertices and promise an accuracy that no registration has; l is about
//      the distance over which fitted surfaces deviate together (surface_errors.hpp).
//   2. alignment: a small rigid motion (w, t) of the after face moves vertex i out by
//      n_i . (w x (x_i - c) + t); its 6 x 6 covariance comes from the stable zone (rigid_zone.hpp).
//   3. bias that no repetition shows, as a deviation common to all vertices: b sum(a_i).
// Var V = a' S a + g' C g + (b sum a)^2, and the interval is V -+ 1.96 sd (GUM, 5.2).
#pragma once

#include <vector>

#include "base/context.hpp"
#include "geometry/surface_errors.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct VolumeErrorModel {
    Vector sd_before_mm;                                   ///< #V, along the normal; empty: exact
    Vector sd_after_mm;                                    ///< #V; empty: exact
    double correlation_length_mm = kSurfaceCorrelationMm;  ///< >= 0
    /// Small motion of the after face: rotation vector (rad) about `alignment_centre`, then
    /// translation (mm). Zero: exact.
    Eigen::Matrix<double, 6, 6> alignment_covariance = Eigen::Matrix<double, 6, 6>::Zero();
    Vector3 alignment_centre = Vector3::Zero();
    double common_bias_mm = 0.0;  ///< >= 0
};

/// Deviation of the signed volume in mL, by source.
struct VolumeUncertainty {
    double sd_ml = 0.0;
    double noise_ml = 0.0;
    double alignment_ml = 0.0;
    double bias_ml = 0.0;
};

/// Prepared once for a pair of faces, then asked for one vertex set after another.
class VolumePropagation {
  public:
    /// Throws Status::invalid_argument for deviations of another length, negative or not finite.
    VolumePropagation(const PointsRef& before, const PointsRef& after,
                      const TrianglesRef& triangles, const VolumeErrorModel& model);
    /// O(n k) for n vertices with k others within four correlation lengths; same bits for any
    /// thread count.
    VolumeUncertainty of(const std::vector<char>& inside, const Context& context) const;
    /// The same for any sum of loads[v] mm^2 times the way that the surface lies too far out at
    /// vertex v: the areas of a part of a zone, or the slope of another measure. Vertices whose
    /// load is zero add nothing.
    VolumeUncertainty of_loads(const Vector& loads_mm2, const Context& context) const;

    /// Half-way between both faces, #V x 3, and there: unit normals, areas in mm^2 per vertex.
    const Points& middle() const { return middle_; }
    const Points& normals() const { return normals_; }
    const Vector& areas_mm2() const { return areas_; }
    /// Deviation of the difference of both surfaces along the normal at each vertex, mm: both fits,
    /// the alignment and the bias.
    Vector total_sd_mm() const;

  private:
    Points middle_, normals_;
    Vector areas_, sd_before_, sd_after_;
    VolumeErrorModel model_;
};

}  // namespace mien
