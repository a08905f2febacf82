#include "template_head.hpp"

#include <algorithm>
#include <map>

#include "sculpture.hpp"
#include "surface_mesher.hpp"

namespace mien::demo {

// Defined in template_marks.cpp.
void mark_template(TemplateHead& head);

namespace {

enum : unsigned { kMiddle = 1, kNeck = 2, kEye = 4, kLipUpper = 8, kLipLower = 16 };
constexpr double kHalfSlit = 0.3;  // mm, half the gap between the lips in the middle

// Edge length in mm: fine at lids and lips, then nose and ears, coarse on the scalp and the neck.
double wanted_size(V3 p) {
    const double ax = std::fabs(p.x);
    double size = mix(8.0, 3.9, ramp(10, 62, p.z - 0.25 * std::max(0.0, p.y - 60)));
    const auto refine = [&](double fine, V3 c, V3 r, double growth) {
        const V3 q{(ax - c.x) / r.x, (p.y - c.y) / r.y, (p.z - c.z) / r.z};
        const double outside = std::max(0.0, norm(q) - 1) * std::min({r.x, r.y, r.z});
        size = std::min(size, fine + growth * outside);
    };
    refine(1.7, {31, 25, 82}, {17, 8, 14}, 0.16);
    refine(1.6, {0, -43, 92}, {28, 9, 18}, 0.16);
    refine(2.0, {0, -14, 104}, {18, 13, 16}, 0.16);
    refine(2.6, {0, 10, 98}, {11, 25, 14}, 0.16);
    refine(2.7, {84, 2, -16}, {14, 32, 22}, 0.20);
    return size;
}

double slit(double x) {
    const double t = x / plan::kMouthHalfWidth;
    return kHalfSlit * std::max(0.0, 1 - t * t);
}

SurfaceMesher half_head() {
    const auto numeric = [](double (*f)(V3)) {
        return Constraint{f, [f](V3 p) {
                              const double h = 1e-3;
                              return V3{f({p.x + h, p.y, p.z}) - f({p.x - h, p.y, p.z}),
                                        f({p.x, p.y + h, p.z}) - f({p.x, p.y - h, p.z}), 0} /
                                     (2 * h);
                          }};
    };
    const std::vector<Constraint> curves{
        {[](V3 p) { return p.x; },
         [](V3) {
             return V3{1, 0, 0};
         }},
        {[](V3 p) { return p.y - plan::kNeckRim; },
         [](V3) {
             return V3{0, 1, 0};
         }},
        numeric([](V3 p) { return plan::eye_outline(p.x, p.y); }),
        numeric([](V3 p) { return p.y - plan::mouth_line(p.x) - slit(p.x); }),
        numeric([](V3 p) { return p.y - plan::mouth_line(p.x) + slit(p.x); })};
    SurfaceMesher mesher({sculpture, sculpture_gradient}, curves, wanted_size);
    mesher.march({0, plan::kNeckRim, -112}, {112, 148, 132}, 4.0);
    mesher.flag_border(kMiddle, [](V3 p) { return p.x < 1e-9; });
    mesher.flag_border(kNeck, [](V3 p) { return p.y < plan::kNeckRim + 1e-9; });
    mesher.remesh(6, false);

    // eye: outline cut into the mesh, inside removed, corners pinned
    const auto front_of_eye = [](V3 p) { return p.z > 60 && p.x > 10 && p.x < 52; };
    const auto outline = [](V3 p) { return plan::eye_outline(p.x, p.y); };
    mesher.insert_curve(kEye, outline, front_of_eye);
    mesher.remove_inside(kEye, [&](V3 p) { return front_of_eye(p) && outline(p) < 0; });
    for (const V3 guess : {V3{plan::kEyeInner, 23, 80}, V3{plan::kEyeOuter, 26, 76}}) {
        const int end = mesher.nearest(guess, kEye);
        V3 p = mesher.points[end];
        p.x = guess.x;
        p.y = guess.y;
        mesher.pin(end, mesher.project(p, kEye), kEye);
    }

    // mouth: corner pinned, line between the lips cut open
    const double half_width = plan::kMouthHalfWidth;
    const double corner_y = plan::mouth_line(half_width);
    const int near_corner = mesher.nearest({half_width, corner_y, 86});
    V3 tip = mesher.points[near_corner];
    tip.x = half_width;
    tip.y = corner_y;
    for (int k = 0; k < 30; ++k) tip.z -= clamp(sculpture(tip), -2, 2);
    mesher.pin(near_corner, tip, kLipUpper | kLipLower);
    mesher.remesh(2, false);  // the triangles around the corner recover from its move
    const int corner = mesher.nearest(tip);
    const auto line = [](V3 p) { return p.y - plan::mouth_line(p.x); };
    mesher.insert_curve(kLipUpper, line, [&](V3 p) {
        return p.z > 75 && p.x < half_width && p.y > -60 && p.y < -30;
    });
    mesher.cut(kLipUpper, kLipLower, line, corner);
    mesher.remesh(14, true);
    mesher.project_all();
    return mesher;
}

// Rows of quads from the border edges of `flag` inwards; place(p, row, upper) gives the new points.
template <class Place>
void extrude(SurfaceMesher& mesh, unsigned flag, int rows, std::vector<unsigned char>& row_of,
             std::vector<int>& root, Place place) {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) ++uses[std::minmax(t[k], t[(k + 1) % 3])];
    std::vector<std::pair<int, int>> rim;
    for (const auto& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const int a = t[k], b = t[(k + 1) % 3];
            if (uses[std::minmax(a, b)] == 1 && (mesh.flags[a] & flag) && (mesh.flags[b] & flag))
                rim.push_back({a, b});
        }
    std::map<int, int> outer;
    for (const auto& [a, b] : rim) outer[a] = a, outer[b] = b;
    for (int row = 1; row <= rows; ++row) {
        std::map<int, int> inner;
        for (const auto& [start, last] : outer) {
            inner[start] = static_cast<int>(mesh.points.size());
            mesh.points.push_back(place(mesh.points[start], row, mesh.flags[start]));
            mesh.flags.push_back(mesh.flags[start]);
            row_of.push_back(static_cast<unsigned char>(row));
            root.push_back(start);
        }
        for (const auto& [a, b] : rim) {
            mesh.triangles.push_back({outer[b], outer[a], inner[a]});
            mesh.triangles.push_back({outer[b], inner[a], inner[b]});
        }
        outer = inner;
    }
}

}  // namespace

TemplateHead make_template_head() {
    SurfaceMesher half = half_head();
    std::vector<unsigned char> row(half.points.size(), 0);
    std::vector<int> root(half.points.size());
    for (std::size_t v = 0; v < root.size(); ++v) root[v] = static_cast<int>(v);
    // Edge of the lids: in towards the eyeball, down to its surface.
    extrude(half, kEye, 2, row, root, [](V3 p, int k, unsigned) {
        const V3 inwards = normalized(mix(normalized(plan::kEyeball - p), V3{0, 0, -1}, 0.5));
        V3 q = p + (k == 1 ? 0.8 : 1.9) * inwards;
        const double r = norm(q - plan::kEyeball), least = plan::kEyeballRadius + 0.2;
        if (r < least) q = plan::kEyeball + (least / r) * (q - plan::kEyeball);
        return q;
    });
    // Wet side of the lips: back and apart.
    extrude(half, kLipUpper | kLipLower, 3, row, root, [](V3 p, int k, unsigned own) {
        static constexpr double kDepth[4] = {0, 1.3, 3.0, 5.2}, kApart[4] = {0, 0.25, 0.9, 1.9};
        const bool corner = (own & kLipUpper) && (own & kLipLower);
        const double t = clamp(p.x / plan::kMouthHalfWidth, 0, 1), taper = 1 - 0.6 * t * t;
        const double side = corner ? 0 : (own & kLipUpper) ? 1 : -1;
        const V3 back = normalized(V3{-0.55 * t, 0, -1});
        return p + (kDepth[k] * taper) * back + V3{0, side * kApart[k] * taper, 0};
    });

    TemplateHead head;
    const int half_count = static_cast<int>(half.points.size());
    head.points = half.points;
    head.triangles = half.triangles;
    head.mirror.resize(half_count);
    for (int v = 0; v < half_count; ++v) {
        if (half.flags[v] & kMiddle) {
            head.points[v].x = 0;
            head.mirror[v] = v;
            continue;
        }
        head.mirror[v] = static_cast<int>(head.points.size());
        head.mirror.push_back(v);
        const V3 p = half.points[v];
        head.points.push_back({-p.x, p.y, p.z});
    }
    for (const auto& t : half.triangles)
        head.triangles.push_back({head.mirror[t[0]], head.mirror[t[2]], head.mirror[t[1]]});
    const std::size_t count = head.points.size();
    head.rim.assign(count, Rim::none);
    head.rim_row.assign(count, 0);
    for (int v = 0; v < half_count; ++v) {
        const unsigned own = half.flags[v];
        Rim rim = Rim::none;
        if ((own & kLipUpper) && (own & kLipLower))
            rim = Rim::lip_corner;
        else if (own & kLipUpper)
            rim = Rim::lip_upper;
        else if (own & kLipLower)
            rim = Rim::lip_lower;
        else if (own & kEye) {
            const V3 edge = half.points[root[row[v] == 2 ? root[v] : v]];
            const double t = (edge.x - plan::kEyeInner) / (plan::kEyeOuter - plan::kEyeInner);
            rim = edge.y >= mix(23.0, 26.0, t) ? Rim::lid_upper : Rim::lid_lower;
        }
        for (int w : {v, head.mirror[v]}) {
            head.rim[w] = rim;
            head.rim_row[w] = row[v];
        }
    }
    head.neighbours.resize(count);
    for (const auto& t : head.triangles)
        for (int k = 0; k < 3; ++k) {
            head.neighbours[t[k]].push_back(t[(k + 1) % 3]);
            head.neighbours[t[k]].push_back(t[(k + 2) % 3]);
        }
    for (auto& ring : head.neighbours) {
        std::sort(ring.begin(), ring.end());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    }
    mark_template(head);
    return head;
}

}  // namespace mien::demo
