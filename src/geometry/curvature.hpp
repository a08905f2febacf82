// Mean, Gaussian and principal curvatures of a face by fitting a cubic height function (a 3-jet,
// Cazals & Pouget 2005) around each vertex, with weights that fall off with distance and a robust
// second pass.
//
// In the tangent frame (u, v) of vertex i, heights of its neighbours within `radius_mm` along the
// surface (k rings, cut by distance) are fitted by
//     h = c0 + c1 u + c2 v + 1/2 (a u^2 + 2 b u v + c v^2) + cubic terms,
// so that noise of the vertex itself (c0) and of its normal (c1, c2) does not enter; the shape
// operator is I^-1 II of the fitted graph. Weights are Gaussian in distance times, after the first
// fit, Tukey's bisquare of the residual over 4.685 times their scale (1.4826 median |residual|), so
// that a spike or an eyelash does not bend the fit.
//
// Sign: positive where the surface bulges outwards (a sphere of radius r with outward normals has
// both curvatures 1 / r).
#pragma once

#include <functional>

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

struct CurvatureOptions {
    double radius_mm = 6.0;  ///< > 0; grown per vertex until there are enough neighbours
    bool robust = true;
};

struct CurvatureField {
    Vector maximal;    ///< #V, 1/mm, k1 >= k2
    Vector minimal;    ///< #V
    Vector mean;       ///< (k1 + k2) / 2
    Vector gaussian;   ///< k1 k2, 1/mm^2
    Points direction;  ///< #V x 3, unit tangent of k1; zero where nothing could be fitted
    Points normals;    ///< #V x 3, normal of the fitted surface
};

/// Vertices with fewer than 6 neighbours on their component get zero curvature. Parallel over
/// vertices, same bits for any thread count. About 0.1 ms a vertex at 30 neighbours. Throws
/// Status::invalid_argument for a radius that is not positive; indices must be in range.
/// `progress`, where given, is called on the calling thread with the share that is done.
CurvatureField estimate_curvature(const PointsRef& vertices, const TrianglesRef& triangles,
                                  const CurvatureOptions& options, const Context& context,
                                  const std::function<void(double)>& progress = {});

}  // namespace mien
