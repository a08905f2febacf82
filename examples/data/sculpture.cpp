#include "sculpture.hpp"

#include <algorithm>

namespace mien::demo {
namespace {

// Cubic smooth minimum of width k: equals min(a, b) where they differ by more than k.
double melt(double a, double b, double k) {
    const double h = std::max(k - std::fabs(a - b), 0.0) / k;
    return std::min(a, b) - h * h * h * k / 6;
}
double carve(double a, double tool, double k) {
    return -melt(-a, tool, k);
}

// Distance to an ellipsoid, first order: exact on the surface and its normal.
double ellipsoid(V3 p, V3 centre, V3 radii) {
    const V3 q = p - centre;
    const V3 a{q.x / radii.x, q.y / radii.y, q.z / radii.z};
    const V3 b{a.x / radii.x, a.y / radii.y, a.z / radii.z};
    const double k0 = norm(a), k1 = norm(b);
    return k1 > 0 ? k0 * (k0 - 1) / k1 : -std::min({radii.x, radii.y, radii.z});
}

// A capsule whose radius runs from ra at a to rb at b.
double capsule(V3 p, V3 a, V3 b, double ra, double rb) {
    const V3 d = b - a;
    const double t = clamp(dot(p - a, d) / dot(d, d), 0, 1);
    return norm(p - a - t * d) - mix(ra, rb, t);
}

// Soft unit bump with half widths s.
double soft(V3 p, V3 c, V3 s) {
    return bump(square((p.x - c.x) / s.x) + square((p.y - c.y) / s.y) + square((p.z - c.z) / s.z));
}

double skull_and_jaw(V3 p) {
    const V3 q{std::sqrt(p.x * p.x + 16), p.y, p.z};     // rounded |x|: no crease in the middle
    double d = ellipsoid(p, {0, 53, -8}, {73, 85, 92});  // brain case
    d = melt(d, ellipsoid(p, {0, 72, -4}, {70, 66, 86}), 14);          // crown
    d = melt(d, ellipsoid(p, {0, 66, 30}, {63, 62, 64}), 20);          // forehead
    d = melt(d, ellipsoid(p, {0, 0, 30}, {64, 68, 61}), 26);           // middle of the face
    d = melt(d, ellipsoid(p, {0, -44, 44}, {47, 44, 47}), 22);         // jaws
    d = melt(d, capsule(q, {47, -42, 12}, {9, -77, 76}, 10, 10), 26);  // edge of the jaw
    d = melt(d, capsule(q, {56, 2, 2}, {48, -40, 12}, 12, 11), 24);    // its rising branch
    d = melt(d, ellipsoid(p, {0, -75, 77}, {13, 13, 17}), 18);         // chin
    return d;
}

double neck(V3 p) {
    // Leans forward on its way up, wider at the foot.
    const double lean = -18 - 0.12 * (p.y + 60);
    const double flare = 9 * square(clamp((-95 - p.y) / 55, 0, 1.4));
    const double top = 22 * square(clamp((p.y + 40) / 60, 0, 1.5));  // closes under the skull
    const double d =
        ellipsoid({p.x, 0, p.z}, {0, 0, lean}, {49 + flare - top, 60, 51 + 0.6 * flare - top});
    return std::max(d, p.y - 20);
}

double nose(V3 p) {
    double d = capsule(p, {0, 32, 86}, {0, 2, 102}, 7.0, 7.4);
    d = melt(d, ellipsoid(p, {0, -1, 88}, {14.5, 25, 17}), 7);  // side walls
    d = melt(d, capsule(p, {0, 4, 102}, {0, -9, 108.5}, 7.4, 9.4), 9);
    for (double side : {-1.0, 1.0})
        d = melt(d, ellipsoid(p, {side * 10.6, -13.2, 99}, {6.2, 6.6, 9.2}), 9);  // wings
    d = melt(d, capsule(p, {0, -14, 108}, {0, -19, 98}, 4.4, 6.0), 7);            // septum
    return d;
}

double muzzle(V3 p) {
    return ellipsoid(p, {0, -39, 62}, {39, 38, 39});
}

// Half the height of a lip's tube at |x| = t * half the mouth; the upper one has Cupid's bow.
double lip_half_height(double t, bool upper) {
    const double taper = std::sqrt(std::max(1 - t * t, 0.0) + 0.004);
    if (!upper) return 5.8 * taper;
    return 5.0 * taper *
           (1 + 0.10 * bump(square((t - 0.24) / 0.16)) - 0.10 * bump(square(t / 0.12)));
}

// One lip as a tube along the arch of the teeth; it thins out towards the corner.
double lip(V3 p, bool upper) {
    const double t = clamp(std::fabs(p.x) / plan::kMouthHalfWidth, 0, 1);
    const double line = plan::mouth_line(clamp(p.x, -25.0, 25.0));
    const double taper = std::sqrt(std::max(1 - t * t, 0.0) + 0.004);
    const double depth = 99.4 - 17.0 * t * t * (0.75 + 0.25 * t);
    const double half = lip_half_height(t, upper), reach = 5.0 * (0.35 + 0.65 * taper);
    const double y = line + (upper ? 0.86 : -0.86) * half;
    const double over_side = std::max(std::fabs(p.x) - 25.0, 0.0);
    const double e = std::sqrt(square((p.y - y) / half) + square((p.z - depth) / reach) +
                               square(over_side / half));
    return (e - 1) * std::min(half, reach) + 2.5 * ramp(21, 25, std::fabs(p.x));
}

double ear(V3 p) {
    // In the ear's own frame: u across the plate, v up along it, w backwards.
    const V3 q = V3{std::fabs(p.x), p.y, p.z} - V3{74, 1, -10};
    const double ct = 0.90, st = 0.436;  // stands off by 26 degrees
    const double u0 = ct * q.x + st * q.z, w0 = st * q.x - ct * q.z;
    const double cb = 0.978, sb = 0.208;  // leans back by 12 degrees
    const double v = cb * q.y + sb * -w0, w = sb * q.y + cb * w0;
    const double wide = v > 0 ? 16.5 : 16.5 + 0.15 * v;
    const double r = std::sqrt(square(v / 29.5) + square(w / wide));
    // plate with a rolled rim, lobe below
    double d = -melt(-(r - 1) * 17, -(std::fabs(u0 - 1.5 * std::min(r, 1.3)) - 3.2), 3.0);
    const double rim = std::sqrt(square((r - 0.92) * 18) + square(u0 - 4.0));
    d = melt(d, rim - 2.9 + 1.2 * ramp(4, -22, v), 3.0);
    d = melt(d, ellipsoid({u0, v, w}, {2.0, -24, -3.5}, {3.8, 8.5, 7.5}), 4.0);
    // inner fold and bowl
    const double ri = std::sqrt(square((v - 2) / 18) + square((w - 1) / 9.5));
    d = melt(d, std::sqrt(square((ri - 1) * 10) + square(u0 - 3.2)) - 1.7, 3.0);
    d = carve(d, ellipsoid({u0, v, w}, {6.0, -3, -3}, {6.4, 11, 7}), 3.0);
    // small flap in front of the bowl, root that joins the head
    d = melt(d, ellipsoid({u0, v, w}, {3.0, -5, -12.5}, {4.0, 5.5, 4.5}), 3.0);
    d = melt(d, ellipsoid({u0, v, w}, {-4, -2, -6}, {7, 22, 9}), 6.0);
    return d;
}

// Bumps (positive: more flesh) and dents that give the face its planes.
double relief(V3 p) {
    const double ax = std::sqrt(p.x * p.x + 4.0);
    const V3 q{ax, p.y, p.z};
    double h = 0;
    h += 3.0 * soft(q, {24, 43, 90}, {17, 6.5, 20});  // brow ridge
    h += 1.5 * soft(q, {42, 40, 80}, {9, 8, 20});
    h -= 1.2 * soft(p, {0, 36, 96}, {9, 6, 20});      // root of the nose
    h += 3.0 * soft(q, {47, 2, 68}, {16, 13, 22});    // cheekbone
    h -= 2.0 * soft(q, {52, -28, 55}, {15, 18, 30});  // hollow below it
    h -= 3.4 * soft(q, {66, 44, 40}, {18, 22, 22});   // temple
    h -= 2.0 * soft(q, {22, -12, 86}, {7, 10, 20});   // beside the wing
    h += 1.8 * soft(q, {31, -14, 80}, {11, 13, 25});  // front of the cheek
    h -= 1.1 * soft(q, {29, -31, 84}, {5, 11, 25});   // fold beside the mouth
    h -= 1.0 * soft(p, {0, -30, 102}, {3.2, 6, 20});  // groove under the nose
    h += 0.7 * soft(q, {5.8, -31, 102}, {2.6, 6, 20});
    h -= 3.6 * soft(p, {0, -59, 95}, {15, 5.5, 20});  // groove above the chin
    h -= 1.5 * soft(q, {29, -45, 82}, {6, 6, 20});    // corner of the mouth
    h -= 2.0 * soft(q, {34, -66, 66}, {12, 9, 20});   // beside the chin
    h += 4.0 * soft(p, {0, -112, 36}, {9, 13, 20});   // larynx
    return h;
}

// Distance to the edge of a cord from behind the ear to the collar bone.
double neck_cord(V3 p) {
    return capsule({std::fabs(p.x), p.y, p.z}, {50, -20, -26}, {14, -160, 20}, 9, 9);
}

}  // namespace

namespace plan {

double eye_outline(double x, double y) {
    const double t = (x - kEyeInner) / (kEyeOuter - kEyeInner), s = 4 * t * (1 - t);
    const double above = y - mix(23.0, 26.0, t);
    const double belly = 0.55 + 0.45 * clamp(s, 0, 1);
    const double half = above > 0 ? 6.4 * belly * (1 + 0.12 * (0.5 - clamp(t, 0, 1)))
                                  : 4.2 * belly * (1 + 0.20 * (clamp(t, 0, 1) - 0.5));
    return square(above / half) - s;
}
double mouth_line(double x) {
    const double t = std::fabs(x) / kMouthHalfWidth;
    return -43.0 - 0.9 * bump(square(t / 0.25)) - 1.0 * t * t;
}

double lip_top(double x) {
    return mouth_line(x) +
           1.62 * lip_half_height(clamp(std::fabs(x) / kMouthHalfWidth, 0, 1), true);
}
double lip_bottom(double x) {
    return mouth_line(x) -
           1.58 * lip_half_height(clamp(std::fabs(x) / kMouthHalfWidth, 0, 1), false);
}

}  // namespace plan

double sculpture(V3 p) {
    double d = skull_and_jaw(p);
    // eye sockets, then the lids over the eyeballs
    const V3 q{std::fabs(p.x), p.y, p.z};
    d = carve(d, ellipsoid(q, {31, 24.5, 101}, {18, 11, 17}), 16);
    d = melt(d, nose(p), 11);
    d = melt(d, norm(q - plan::kEyeball) - (plan::kEyeballRadius + 1.5), 9);
    d = melt(d, muzzle(p), 12);
    d -= relief(p);
    if (p.y > -75 && p.y < -15 && p.z > 60) {
        const double lips = melt(lip(p, true), lip(p, false), 0.9);
        d = melt(d, lips, 4.5);
    }
    if (p.y < 15 && p.z > 80 && q.x < 14)  // nostrils
        d = carve(d, ellipsoid(q, {6.0, -19.0, 104.0}, {3.3, 4.2, 4.8}), 2.5);
    double below = neck(p);
    below = melt(below, neck_cord(p), 14);
    d = melt(d, below, 20);
    if (q.x > 45 && p.z > -60 && p.z < 50 && std::fabs(p.y) < 60) d = melt(d, ear(p), 5);
    return d;
}

V3 sculpture_gradient(V3 p) {
    const double h = 0.02;
    return V3{sculpture({p.x + h, p.y, p.z}) - sculpture({p.x - h, p.y, p.z}),
              sculpture({p.x, p.y + h, p.z}) - sculpture({p.x, p.y - h, p.z}),
              sculpture({p.x, p.y, p.z + h}) - sculpture({p.x, p.y, p.z - h})} /
           (2 * h);
}

}  // namespace mien::demo
