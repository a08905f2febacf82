// Closest point of a triangle to a point, by the Voronoi region the point falls into (Ericson,
// Real-Time Collision Detection, 5.1.5). Triangles without area, or with an angle below a
// millionth, fall back to their edges: the textbook version turns them into NaN or, by
// cancellation, into noise.
#pragma once

#include "base/types.hpp"

namespace mien {

struct TrianglePlace {
    Vector3 barycentric;
    Vector3 point;
    double squared_distance;
};

inline double segment_parameter(const Vector3& p, const Vector3& a, const Vector3& ab) {
    const double length = ab.squaredNorm();
    if (!(length > 0)) return 0;
    return std::min(1.0, std::max(0.0, (p - a).dot(ab) / length));
}

inline TrianglePlace closest_on_triangle(const Vector3& p, const Vector3& a, const Vector3& b,
                                         const Vector3& c) {
    const Vector3 ab = b - a, ac = c - a, ap = p - a;
    const auto place = [&](double v, double w) {
        const Vector3 q = a + v * ab + w * ac;
        return TrianglePlace{Vector3(1 - v - w, v, w), q, (p - q).squaredNorm()};
    };
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    const double aa = ab.squaredNorm(), cc = ac.squaredNorm(), mixed = ab.dot(ac);
    const double d3 = d1 - aa, d4 = d2 - mixed;  // relative to b
    const double d5 = d1 - mixed, d6 = d2 - cc;  // relative to c
    const double twice_area_squared = aa * cc - mixed * mixed;
    if (!(twice_area_squared > 1e-12 * aa * cc)) {
        const double t_ab = segment_parameter(p, a, ab), t_ac = segment_parameter(p, a, ac);
        const double t_bc = segment_parameter(p, b, c - b);
        TrianglePlace best = place(t_ab, 0);
        const TrianglePlace on_ac = place(0, t_ac), on_bc = place(1 - t_bc, t_bc);
        if (on_ac.squared_distance < best.squared_distance) best = on_ac;
        if (on_bc.squared_distance < best.squared_distance) best = on_bc;
        return best;
    }
    if (d1 <= 0 && d2 <= 0) return place(0, 0);
    if (d3 >= 0 && d4 <= d3) return place(1, 0);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return place(d1 / (d1 - d3), 0);
    if (d6 >= 0 && d5 <= d6) return place(0, 1);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return place(0, d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return place(1 - w, w);
    }
    const double scale = 1.0 / (va + vb + vc);
    return place(vb * scale, vc * scale);
}

}  // namespace mien
