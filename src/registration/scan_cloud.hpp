// Spacing and normals of a scan that is a cloud of points, without any triangle.
#pragma once

#include "registration/scan_surface.hpp"

namespace mien {

/// Median distance to the nearest other point, from a sample, mm. At least two points.
/// O(sample #V).
double cloud_spacing(const Points& points, const ScanSurfaceSettings& settings);

/// #V x 3: the direction in which the points within `radius_mm` spread least (the last principal
/// axis of Hoppe et al., Surface reconstruction from unorganized points, 1992), turned away from
/// the cloud's middle, which lies behind a face; zero where too few points are near. O(V log V).
Points cloud_normals(const Points& points, double radius_mm, const ScanSurfaceSettings& settings,
                     const Context& context);

}  // namespace mien
