// The template with what moves it: inner points, normals, and how much each vertex follows the jaw.
#include <cmath>

#include "people.hpp"
#include "sculpture.hpp"

namespace mien::demo {
namespace {

double distance_to_bone(V3 p) {  // lower jaw: chin to angle to joint
    const V3 q{std::fabs(p.x), p.y, p.z};
    const auto segment = [&](V3 a, V3 b) {
        const V3 d = b - a;
        const double t = clamp(dot(q - a, d) / dot(d, d), 0, 1);
        return norm(q - a - t * d);
    };
    return std::fmin(segment({6, -76, 80}, {47, -44, 14}), segment({47, -44, 14}, {55, -12, 6}));
}

// A harmonic function on the surface (weights by inverse edge length): 1 on the lower lip, the chin
// and along the jaw bone, 0 on the upper lip, above the nose's base, on the nape and low on the
// neck. The open mouth keeps the lips apart. Then a little smoothing takes away the kinks at the
// fixed ends.
std::vector<double> jaw_field(const TemplateHead& head) {
    const std::size_t n = head.points.size();
    std::vector<double> w(n, 0.5);
    std::vector<char> fixed(n, 0);
    for (std::size_t v = 0; v < n; ++v) {
        const V3 p = head.points[v];
        const double x = std::fabs(p.x);
        const auto fix = [&](double value) {
            w[v] = value;
            fixed[v] = 1;
        };
        if (head.rim[v] == Rim::lip_lower)
            fix(mix(1.0, 0.55, ramp(10, 25, x)));
        else if (head.rim[v] == Rim::lip_upper)
            fix(mix(0.0, 0.35, ramp(15, 25, x)));
        else if (head.rim[v] == Rim::lip_corner)
            fix(0.45);
        else if (p.y > -16 || p.z < -12 || p.y < -112)
            fix(0);
        else if (p.y > -40 && x < 14 && p.z > 85)
            fix(0);
        else if (distance_to_bone(p) < 19 && p.y < -24)
            fix(1 - 0.75 * ramp(-44, -24, p.y));
        else if (p.y < -55 && x < 18 && p.z > 82)
            fix(1);
    }
    std::vector<double> next;
    for (int sweep = 0; sweep < 240; ++sweep) {
        const bool smoothing = sweep >= 230;
        if (smoothing) next = w;
        for (std::size_t v = 0; v < n; ++v) {
            if ((fixed[v] && !smoothing) || head.rim[v] >= Rim::lip_upper) continue;
            double sum = 0, weights = 0;
            for (int u : head.neighbours[v]) {
                const double c = 1 / (norm(head.points[u] - head.points[v]) + 0.1);
                sum += c * w[u];
                weights += c;
            }
            (smoothing ? next : w)[v] = sum / weights;
        }
        if (smoothing) w = next;
    }
    // The same on both sides, whatever the order of the sweeps.
    for (std::size_t v = 0; v < n; ++v) {
        const std::size_t m = static_cast<std::size_t>(head.mirror[v]);
        if (m > v) w[v] = w[m] = 0.5 * (w[v] + w[m]);
    }
    return w;
}

}  // namespace

std::vector<V3> normals_of(const std::vector<V3>& points,
                           const std::vector<std::array<int, 3>>& triangles) {
    std::vector<V3> normals(points.size());
    for (const auto& t : triangles) {
        const V3 n = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
        for (int v : t) normals[v] += n;
    }
    for (V3& n : normals) n = normalized(n);
    return normals;
}

Anatomy make_anatomy() {
    Anatomy anatomy;
    anatomy.head = make_template_head();
    anatomy.rest = anatomy.head.points;
    anatomy.normals = normals_of(anatomy.head.points, anatomy.head.triangles);
    anatomy.jaw = jaw_field(anatomy.head);
    for (int side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1 : -1;
        anatomy.eyeball[side] = static_cast<int>(anatomy.rest.size());
        anatomy.rest.push_back({sign * plan::kEyeball.x, plan::kEyeball.y, plan::kEyeball.z});
    }
    for (int side = 0; side < 2; ++side) {
        anatomy.hinge[side] = static_cast<int>(anatomy.rest.size());
        anatomy.rest.push_back({side == 0 ? 56.0 : -56.0, -4, 2});
    }
    return anatomy;
}

}  // namespace mien::demo
