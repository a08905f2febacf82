// What a template's slide along the skin does to a measure, to first order. A vertex that lies s_i
// off along the skin (per direction of the tangent plane, correlated over the length l like the
// errors along the normal) changes a measure of tangential slope g_i by g_i . s_i:
//     Var = sum_ij g_i . g_j s_i s_j exp(-|x_i - x_j|^2 / (2 l^2)), for each of both faces.
#pragma once

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

/// points, slopes: #V x 3; place sd: #V, per axis, of each face. A place's deviation per axis is a
/// mean over three axes of which the normal one is small: the other two have sqrt(3 / 2) of it.
/// O(n k) for n vertices with a slope and k neighbours within four lengths; same bits for any
/// thread count.
double slide_sd(const Context& context, const Points& points, const Points& slopes,
                const Vector& place_sd_before_mm, const Vector& place_sd_after_mm,
                double correlation_length_mm);

}  // namespace mien
