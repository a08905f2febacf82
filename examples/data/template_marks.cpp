// Landmarks, zones and colours of the template, from the plan of the sculpture.
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "sculpture.hpp"
#include "template_head.hpp"

namespace mien::demo {

namespace {

std::string numbered(const char* stem, int k, int digits = 1) {
    std::string n = std::to_string(k);
    while (static_cast<int>(n.size()) < digits) n.insert(0, "0");
    return stem + n;
}

struct Marker {
    TemplateHead& head;

    int nearest(V3 p, bool skin_only = true) const {
        int best = 0;
        double least = 1e300;
        for (std::size_t v = 0; v < head.points.size(); ++v) {
            if (skin_only && (head.rim_row[v] != 0)) continue;
            const double d = norm(head.points[v] - p);
            if (d < least) {
                least = d;
                best = static_cast<int>(v);
            }
        }
        return best;
    }
    // The skin first met by a look along -z at (x, y).
    int front(double x, double y) const {
        V3 p{x, y, 135};
        for (int k = 0; k < 400 && sculpture(p) > 0.02; ++k) p.z -= 0.6 * sculpture(p);
        return nearest(p);
    }
    int rim(Rim which, double x) const {
        int best = -1;
        double least = 1e300;
        for (std::size_t v = 0; v < head.points.size(); ++v) {
            if (head.rim[v] != which || head.rim_row[v] != 0) continue;
            const double d = std::fabs(head.points[v].x - x);
            if (d < least) {
                least = d;
                best = static_cast<int>(v);
            }
        }
        return best;
    }
    void add(const std::string& name, int vertex) { head.landmarks.emplace_back(name, vertex); }
};

// z of the line that bounds the face towards ear and neck, at height y.
double jaw_z(double y) {
    static constexpr double kY[] = {-91, -88, -79, -68, -52, -33, -14, 24, 60, 100};
    static constexpr double kZ[] = {92, 84, 68, 55, 42, 32, 26, 20, 20, 30};
    for (int k = 0; k + 1 < 10; ++k)
        if (y <= kY[k + 1])
            return mix(kZ[k], kZ[k + 1], clamp((y - kY[k]) / (kY[k + 1] - kY[k]), 0, 1));
    return 30;
}

double distance_to_segment(double x, double y, double ax, double ay, double bx, double by) {
    const double t = clamp(
        ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / (square(bx - ax) + square(by - ay)), 0, 1);
    return std::sqrt(square(x - mix(ax, bx, t)) + square(y - mix(ay, by, t)));
}

bool in_face(V3 p) {
    const double hair_line = 93 - 0.006 * p.x * p.x;
    return p.z > jaw_z(p.y) && p.y < hair_line && p.y > -90;
}

// Zone of a point of the face with x >= 0, or "" (only "face").
std::string zone_of(V3 p) {
    const double x = std::fabs(p.x), y = p.y;
    const double nose_half = mix(9.0, 18.5, ramp(18, -12, y));
    if (y < 33 && y > -23.5 && x < nose_half && p.z > 80) return "nose";
    if (square((x - 31) / 23) + square((y - 26) / 15) < 1 && x >= nose_half) return "eye";
    if (y > 44 && x < 54) return "forehead";
    if (y < 44 && y > -12 && x < nose_half && y >= 33) return "";
    if (y <= -20 && y > -57 && x < 30 && square(x / 31) + square((y + 42) / 26) < 1) return "mouth";
    if (y <= -56 && x < 24) return "chin";
    if (distance_to_segment(x, y, 20, -9, 35, -46) < 5.5) return "nasolabial";
    if (y < 12 && y > -48 && x > 18 && x < 64 && p.z > 40) return "cheek";
    return "";
}

void mark_landmarks(TemplateHead& head) {
    Marker m{head};
    // left half of the jaw, from the chin up; the right half mirrors it
    const V3 jaw[9] = {{0, -88, 88},  {14, -86, 80}, {28, -79, 68}, {42, -68, 55}, {55, -52, 42},
                       {64, -33, 32}, {68, -14, 26}, {70, 5, 22},   {71, 24, 20}};
    for (int k = 0; k < 17; ++k) {
        V3 p = jaw[k < 8 ? 8 - k : k - 8];
        for (int step = 0; step < 8; ++step) {
            const V3 g = sculpture_gradient(p);
            p -= (sculpture(p) / dot(g, g)) * g;
        }
        const int v = m.nearest(p);
        m.add(numbered("jaw_", k, 2), k < 8 ? head.mirror[v] : v);
    }
    const double brow_x[5] = {11, 21, 31, 41, 49.5}, brow_y[5] = {38, 42, 44, 42.5, 38};
    for (int k = 0; k < 5; ++k)
        m.add(numbered("brow_right_", k), head.mirror[m.front(brow_x[4 - k], brow_y[4 - k])]);
    for (int k = 0; k < 5; ++k) m.add(numbered("brow_left_", k), m.front(brow_x[k], brow_y[k]));
    const double bridge[4] = {27, 15, 3, -8.5};
    const auto middle = [&](double y) {
        // on the mirror plane, so that a symmetric face has symmetric landmarks
        int best = 0;
        double least = 1e300;
        for (std::size_t v = 0; v < head.points.size(); ++v) {
            const V3 p = head.points[v];
            if (p.x != 0 || p.z < 70 || head.rim_row[v] != 0) continue;
            if (std::fabs(p.y - y) < least) {
                least = std::fabs(p.y - y);
                best = static_cast<int>(v);
            }
        }
        return best;
    };
    for (int k = 0; k < 4; ++k) m.add(numbered("nose_bridge_", k), middle(bridge[k]));
    const int wing = m.front(13.5, -19.5), sill = m.front(6.5, -23.5);
    const int base[5] = {head.mirror[wing], head.mirror[sill], middle(-23.5), sill, wing};
    for (int k = 0; k < 5; ++k) m.add(numbered("nose_base_", k), base[k]);

    const auto corner = [&](double x, double y) {
        int best = 0;
        double least = 1e300;
        for (std::size_t v = 0; v < head.points.size(); ++v) {
            if (head.rim[v] != Rim::lid_upper && head.rim[v] != Rim::lid_lower) continue;
            if (head.rim_row[v] != 0) continue;
            const double d = square(head.points[v].x - x) + square(head.points[v].y - y);
            if (d < least) {
                least = d;
                best = static_cast<int>(v);
            }
        }
        return best;
    };
    const int eye[6] = {corner(plan::kEyeInner, 23), m.rim(Rim::lid_upper, 26),
                        m.rim(Rim::lid_upper, 37),   corner(plan::kEyeOuter, 26),
                        m.rim(Rim::lid_lower, 37),   m.rim(Rim::lid_lower, 26)};
    const int right_order[6] = {3, 2, 1, 0, 5, 4};
    for (int k = 0; k < 6; ++k) m.add(numbered("eye_right_", k), head.mirror[eye[right_order[k]]]);
    for (int k = 0; k < 6; ++k) m.add(numbered("eye_left_", k), eye[k]);

    const auto lip = [&](double x) { return m.front(x, plan::lip_top(x)); };
    const auto below = [&](double x) { return m.front(x, plan::lip_bottom(x)); };
    const int tip = m.rim(Rim::lip_corner, plan::kMouthHalfWidth);
    const int upper[3] = {middle(plan::lip_top(0)), lip(6.0), lip(15.5)};
    const int lower[3] = {middle(plan::lip_bottom(0)), below(8.5), below(16.5)};
    const int outer[12] = {head.mirror[tip],
                           head.mirror[upper[2]],
                           head.mirror[upper[1]],
                           upper[0],
                           upper[1],
                           upper[2],
                           tip,
                           lower[2],
                           lower[1],
                           lower[0],
                           head.mirror[lower[1]],
                           head.mirror[lower[2]]};
    for (int k = 0; k < 12; ++k) m.add(numbered("mouth_outer_", k, 2), outer[k]);
    const int in_corner = m.rim(Rim::lip_upper, 22), in_up = m.rim(Rim::lip_upper, 10);
    const int in_low = m.rim(Rim::lip_lower, 10);
    const int inner[8] = {head.mirror[in_corner],
                          head.mirror[in_up],
                          m.rim(Rim::lip_upper, 0),
                          in_up,
                          in_corner,
                          in_low,
                          m.rim(Rim::lip_lower, 0),
                          head.mirror[in_low]};
    for (int k = 0; k < 8; ++k) m.add(numbered("mouth_inner_", k), inner[k]);
}

void mark_zones(TemplateHead& head) {
    std::vector<std::pair<std::string, std::vector<int>>> zones;
    for (const char* name :
         {"face", "forehead", "nose", "mouth", "chin", "cheek_left", "cheek_right",
          "nasolabial_left", "nasolabial_right", "eye_left", "eye_right"})
        zones.push_back({name, {}});
    for (std::size_t v = 0; v < head.points.size(); ++v) {
        const V3 p = head.points[v];
        std::string name;
        if (head.rim[v] >= Rim::lip_upper)
            name = "mouth";
        else if (head.rim[v] != Rim::none)
            name = "eye";
        else if (in_face(p))
            name = zone_of(p);
        else
            continue;
        zones[0].second.push_back(static_cast<int>(v));
        if (name == "eye" || name == "cheek" || name == "nasolabial")
            name += p.x >= 0 ? "_left" : "_right";
        for (auto& [zone, members] : zones)
            if (zone == name) members.push_back(static_cast<int>(v));
    }
    head.zones = std::move(zones);
}

void mark_colors(TemplateHead& head) {
    const V3 skin{222, 178, 152}, flush{214, 146, 126}, lip{190, 112, 106}, hair{84, 62, 48};
    head.colors.resize(head.points.size());
    for (std::size_t v = 0; v < head.points.size(); ++v) {
        const V3 p = head.points[v];
        const double x = std::fabs(p.x);
        V3 c = skin;
        const auto paint = [&](V3 color, double amount) { c = mix(c, color, clamp(amount, 0, 1)); };
        paint(flush,
              0.55 * bump(square((x - 42) / 18) + square((p.y + 6) / 16)) * ramp(30, 55, p.z));
        paint(flush, 0.5 * bump(square(x / 13) + square((p.y + 10) / 10)) * ramp(80, 95, p.z));
        paint(flush, 0.4 * ramp(60, 74, x) * ramp(-40, -20, p.y) * ramp(40, 25, p.y));
        if (p.z > 75 && x < plan::kMouthHalfWidth) {
            const double edge = std::min(plan::lip_top(p.x) - p.y, p.y - plan::lip_bottom(p.x));
            paint(lip, ramp(-1.2, 0.8, edge));
            if (edge > -0.2 || head.rim[v] >= Rim::lip_upper)
                head.lips.push_back(static_cast<int>(v));
        }
        if (head.rim[v] >= Rim::lip_upper)
            c = mix(lip, V3{120, 50, 48}, 0.3 * head.rim_row[v]);
        else if (head.rim[v] != Rim::none)
            paint(V3{196, 132, 120}, 0.6);
        double brow = 1e9;
        const double bx[5] = {11, 21, 31, 41, 51}, by[5] = {38, 41.5, 43.5, 42.5, 37.5};
        for (int k = 0; k < 4; ++k)
            brow = std::min(brow, distance_to_segment(x, p.y, bx[k], by[k], bx[k + 1], by[k + 1]));
        if (p.z > 50) paint(hair, 0.85 * ramp(4.2, 2.0, brow + 0.03 * (x - 11)));
        if (x < 11 && p.y < -14 && p.z > 97)  // nostril
            paint(V3{90, 50, 44}, 0.9 * bump(square((x - 6) / 3) + square((p.y + 17.5) / 3.5)));
        for (int k = 0; k < 3; ++k) head.colors[v][k] = static_cast<unsigned char>(c[k] + 0.5);
    }
}

}  // namespace

void mark_template(TemplateHead& head) {
    mark_landmarks(head);
    mark_zones(head);
    mark_colors(head);
}

}  // namespace mien::demo
