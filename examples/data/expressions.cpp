// Twenty expressions as muscles and bones make them: the jaw turns about its joints, the lids roll
// over the eyeballs, the rest are soft pulls at places of the face. Everything is measured on the
// person at hand (joints, lids, width and height of mouth and face), strength differs from person
// to person and from side to side, and one more muscle twitches a little, so that no bilinear model
// holds exactly.
#include <algorithm>
#include <cmath>
#include <map>

#include "people.hpp"
#include "sculpture.hpp"

namespace mien::demo {
namespace {

// Action units; all are one-sided pairs (left, right) except those from kJawOpen on.
enum Unit {
    kSmile,
    kFrown,
    kDimple,
    kStretch,
    kUpperUp,
    kLowerDown,
    kPress,
    kCheekSquint,
    kPuff,
    kBrowDown,
    kBrowInnerUp,
    kBrowOuterUp,
    kSneer,
    kBlink,
    kPaired,
    kJawOpen = kPaired,
    kJawLeft,
    kJawRight,
    kJawForward,
    kMouthLeft,
    kMouthRight,
    kShrugLower,
    kShrugUpper,
    kPucker,
    kFunnel,
    kRollLower,
    kRollUpper,
    kUnits
};

struct Recipe {
    const char* name;
    std::vector<std::pair<Unit, double>> units;
};

const std::vector<Recipe>& recipes() {
    static const std::vector<Recipe> all{
        {"neutral", {}},
        {"mouth_stretch", {{kJawOpen, 1.0}, {kLowerDown, 0.3}}},
        {"smile", {{kSmile, 0.7}, {kCheekSquint, 0.3}}},
        {"brow_lower", {{kBrowDown, 1.0}}},
        {"brow_raiser", {{kBrowInnerUp, 1.0}, {kBrowOuterUp, 1.0}}},
        {"anger", {{kBrowDown, 0.9}, {kSneer, 0.9}, {kPress, 0.5}}},
        {"jaw_left", {{kJawLeft, 1.0}}},
        {"jaw_right", {{kJawRight, 1.0}}},
        {"jaw_forward", {{kJawForward, 1.0}}},
        {"mouth_left", {{kMouthLeft, 1.0}}},
        {"mouth_right", {{kMouthRight, 1.0}}},
        {"dimpler", {{kDimple, 1.0}}},
        {"chin_raiser", {{kShrugLower, 1.0}, {kShrugUpper, 0.5}}},
        {"lip_puckerer", {{kPucker, 1.0}}},
        {"lip_funneler", {{kFunnel, 1.0}, {kJawOpen, 0.15}}},
        {"sadness", {{kFrown, 0.8}, {kBrowInnerUp, 0.8}}},
        {"lip_roll", {{kRollLower, 1.0}, {kRollUpper, 1.0}}},
        {"grin", {{kSmile, 0.8}, {kUpperUp, 0.8}, {kLowerDown, 0.8}, {kStretch, 0.4}}},
        {"cheek_blowing", {{kPuff, 1.0}}},
        {"eyes_closed", {{kBlink, 1.0}}},
    };
    return all;
}

// Strength of every unit, left and right.
struct Strengths {
    double left[kUnits] = {}, right[kUnits] = {};
};

/// Of the non-linear family: strength, asymmetry and the pulls that join in are smooth functions of
/// who the person is; chance of a stated size is all that is left.
Strengths strengths_of_identity(const Person& person, int expression) {
    Random random(person.seed, 1000003u * static_cast<std::uint64_t>(person.subject) + 5000 +
                                   static_cast<std::uint64_t>(expression));
    const auto of = [&](std::size_t k) { return person.places[k % person.places.size()]; };
    const double phase = 0.7 * expression;
    Strengths s;
    std::size_t unit_number = 0;
    for (const auto& [unit, weight] : recipes()[static_cast<std::size_t>(expression)].units) {
        const std::size_t k = 3 * static_cast<std::size_t>(unit);
        const double gain = 1 + 0.22 * sin_of(1.3 * of(k) + phase) +
                            0.12 * sin_of(of(k + 1) * of(k + 4)) +
                            person.strength_noise * random.normal();
        const double lopsided =
            unit < kPaired ? 0.15 * sin_of(1.1 * of(k + 2) + 0.5 * of(k + 7)) : 0;
        // The second pull of a recipe is strong in some people and nearly missing in others.
        const double share = unit_number++ == 0 ? 1 : 0.65 + 0.35 * sin_of(of(k + 5) + phase);
        s.left[unit] += weight * share * clamp(gain * (1 + lopsided), 0.4, 1.35);
        s.right[unit] += weight * share * clamp(gain * (1 - lopsided), 0.4, 1.35);
    }
    return s;
}

Strengths strengths_of(const Person& person, int expression) {
    if (!person.places.empty()) return strengths_of_identity(person, expression);
    Random random(person.seed, 1000003u * static_cast<std::uint64_t>(person.subject) + 1000 +
                                   static_cast<std::uint64_t>(expression));
    Strengths s;
    for (const auto& [unit, weight] : recipes()[static_cast<std::size_t>(expression)].units) {
        const double gain = clamp(person.liveliness * (1 + 0.15 * random.normal()), 0.5, 1.3);
        const double lopsided = unit < kPaired ? 0.12 * random.normal() : 0;
        s.left[unit] += weight * clamp(gain * (1 + lopsided), 0.4, 1.35);
        s.right[unit] += weight * clamp(gain * (1 - lopsided), 0.4, 1.35);
    }
    if (expression != 0) {
        // Closed lids stay closed and a mouth that opens stays open: only soft pulls twitch.
        static constexpr Unit kTwitch[] = {kSmile,       kFrown, kDimple,   kStretch,
                                           kCheekSquint, kPuff,  kBrowDown, kBrowInnerUp,
                                           kBrowOuterUp, kSneer};
        const Unit unit = kTwitch[random.bits() % 10];
        const double extra = 0.1 * random.uniform();
        s.left[unit] += extra;
        s.right[unit] += extra;
    }
    return s;
}

double soft(V3 p, V3 c, V3 r) {
    return bump(square((p.x - c.x) / r.x) + square((p.y - c.y) / r.y) + square((p.z - c.z) / r.z));
}

// Sizes of the person relative to the template, by which pulls are scaled.
struct Sizes {
    double mouth = 1, lips = 1, eyes = 1, face = 1, brow = 1;
};

double span(const Anatomy& a, const std::vector<V3>& x, const char* from, const char* to) {
    int u = 0, v = 0;
    for (const auto& [name, vertex] : a.head.landmarks) {
        if (name == from) u = vertex;
        if (name == to) v = vertex;
    }
    return norm(x[u] - x[v]) / norm(a.rest[u] - a.rest[v]);
}

Sizes sizes_of(const Anatomy& a, const std::vector<V3>& x) {
    Sizes s;
    s.mouth = span(a, x, "mouth_outer_00", "mouth_outer_06");
    s.lips = span(a, x, "mouth_outer_03", "mouth_outer_09");
    s.eyes = span(a, x, "eye_left_0", "eye_left_3");
    s.face = span(a, x, "nose_bridge_0", "jaw_08");
    s.brow = span(a, x, "brow_left_2", "eye_left_1");
    return s;
}

// Soft pulls at template position p (x >= 0 side given by `own`, the strengths of that side).
V3 pulls(V3 p, double jaw, const double* own, const Sizes& size) {
    const V3 q{std::fabs(p.x), p.y, p.z};
    const double s = p.x / std::sqrt(p.x * p.x + 9);  // -1..1
    const double upper = 1 - jaw, across = q.x / plan::kMouthHalfWidth;
    const double line = plan::mouth_line(clamp(p.x, -25, 25));
    const double corner = soft(q, {26, -44, 82}, {15, 13, 34});
    const double lips = soft(q, {0, -43, 96}, {26, 11, 26});
    const double mouth = soft(q, {0, -43, 92}, {33, 17, 34});
    V3 d;
    const auto add = [&](double amount, double x, double y, double z) {
        d += amount * V3{s * x * size.mouth, y * size.face, z};
    };
    if (own[kSmile] != 0) {
        add(own[kSmile] * corner, 6.5, 8.0, -5.5);
        add(own[kSmile] * soft(q, {42, -12, 72}, {16, 15, 30}), 2.2, 3.2, 2.6);
        add(own[kSmile] * soft(q, {31, -30, 82}, {5, 11, 26}), 0, 0.6, -2.0);
        add(own[kSmile] * soft(q, {14, -15, 99}, {8, 8, 14}), 1.0, 0.5, -0.4);
    }
    if (own[kFrown] != 0) {
        add(own[kFrown] * corner, 1.0, -7.0, -1.5);
        add(own[kFrown] * soft(q, {30, -56, 76}, {10, 10, 30}), 0.6, -2.0, 1.2);
        add(own[kFrown] * lips, 0, -0.8, 0.6);
    }
    if (own[kDimple] != 0) {
        add(own[kDimple] * corner, 4.2, 0.8, -5.0);
        add(own[kDimple] * soft(q, {34, -43, 76}, {6, 7, 26}), 0, 0, -2.8);
        add(own[kDimple] * soft(q, {44, -40, 66}, {9, 14, 26}), 1.4, 0, 1.0);
    }
    if (own[kStretch] != 0) {
        add(own[kStretch] * corner, 7.0, -2.5, -5.0);
        add(own[kStretch] * soft(q, {36, -62, 66}, {14, 14, 30}), 2.0, -1.5, 0);
    }
    if (own[kUpperUp] != 0) {
        const double lift = upper * soft(q, {9, -38, 98}, {13, 9, 26});
        add(own[kUpperUp] * lift * size.lips, 0, 4.6, 0.5);
        add(own[kUpperUp] * soft(q, {17, -20, 92}, {9, 9, 20}), 0.8, 1.6, 0.4);
    }
    if (own[kLowerDown] != 0) {
        const double drop = jaw * soft(q, {8, -49, 96}, {14, 10, 26});
        add(own[kLowerDown] * drop * size.lips, 0.4, -5.2, -0.4);
    }
    if (own[kPress] != 0) {
        const double rest = soft(q, {0, -43, 96}, {22, 8, 26});
        add(own[kPress] * rest, 0, -0.28 * (p.y - line), -1.6);
        add(own[kPress] * corner, 1.0, -0.4, -1.0);
        add(own[kPress] * soft(q, {0, -56, 94}, {16, 5, 20}), 0, 0.5, 1.2);
    }
    if (own[kCheekSquint] != 0) {
        add(own[kCheekSquint] * soft(q, {38, 2, 76}, {17, 10, 28}), 0.6, 5.0, 2.0);
        const double lid = soft(q, {32, 17, 82}, {13, 4.5, 26});
        add(own[kCheekSquint] * lid * size.eyes, 0, 1.8, 0.3);
    }
    if (own[kPuff] != 0) {
        add(own[kPuff] * soft(q, {46, -36, 66}, {18, 17, 34}), 8.5, 0, 6.5);
        add(own[kPuff] * soft(q, {14, -30, 98}, {16, 8, 22}), 0, 0, 2.4);
        add(own[kPuff] * soft(q, {12, -60, 92}, {16, 8, 22}), 0, 0, 1.8);
        add(own[kPuff] * corner, -1.8, 0, 1.6);
    }
    if (own[kBrowDown] != 0) {
        const double y = size.brow;
        add(own[kBrowDown] * soft(q, {18, 43, 90}, {15, 9, 26}), -1.6, -4.6 * y, 1.6);
        add(own[kBrowDown] * soft(q, {42, 43, 80}, {13, 9, 26}), -0.5, -2.8 * y, 0.6);
        add(own[kBrowDown] * soft(q, {6, 40, 98}, {3.0, 7, 20}), 0, 0, 1.3);
        add(own[kBrowDown] * soft(q, {0, 40, 98}, {2.4, 8, 20}), 0, 0, -1.2);
        add(own[kBrowDown] * soft(q, {0, 31, 98}, {10, 5, 20}), 0, -1.5, 0.8);
    }
    if (own[kBrowInnerUp] != 0) {
        add(own[kBrowInnerUp] * soft(q, {15, 45, 92}, {14, 12, 28}), -0.8, 5.8 * size.brow, 0.6);
        add(own[kBrowInnerUp] * soft(q, {14, 66, 92}, {18, 12, 30}), 0, 2.6, 1.2);
    }
    if (own[kBrowOuterUp] != 0) {
        add(own[kBrowOuterUp] * soft(q, {43, 43, 80}, {14, 12, 30}), 0.6, 5.2 * size.brow, -0.6);
        add(own[kBrowOuterUp] * soft(q, {40, 64, 84}, {18, 13, 30}), 0, 2.2, 0.8);
    }
    if (own[kSneer] != 0) {
        add(own[kSneer] * soft(q, {13, -13, 99}, {8, 9, 16}), 1.2, 3.2, 0.4);
        add(own[kSneer] * soft(q, {11, 12, 94}, {8, 12, 18}), 0, 1.6, 1.2);
        add(own[kSneer] * upper * soft(q, {13, -33, 98}, {11, 9, 24}), 0.4, 2.4, 0.4);
        add(own[kSneer] * soft(q, {23, -14, 88}, {5, 10, 22}), 0, 0.5, -1.6);
    }
    // Both sides at once from here; the sign of x comes back by `s`.
    const double shift = own[kMouthLeft] - own[kMouthRight];
    if (shift != 0) {
        // Slides along the arch of the teeth.
        const double dx = 8.0 * size.mouth * shift * mouth;
        d += V3{dx, 0.6 * std::fabs(dx) / 8 * clamp(p.x * shift / 25, -1, 1),
                -0.020 * (2 * p.x * dx + dx * dx) * mouth};
        d += V3{2.0 * shift * soft(p, {0, -14, 106}, {16, 10, 18}), 0, 0};
    }
    if (own[kShrugLower] != 0) {
        add(own[kShrugLower] * soft(q, {0, -49, 96}, {20, 9, 26}) * jaw, 0, 3.0 * size.lips, 2.4);
        add(own[kShrugLower] * soft(q, {0, -70, 92}, {19, 13, 26}), 0, 5.0, 1.4);
        add(own[kShrugLower] * soft(q, {0, -60, 94}, {14, 4.5, 22}), 0, 1.0, -1.8);
        add(own[kShrugLower] * upper * soft(q, {0, -40, 98}, {20, 9, 26}), 0, 3.0 * size.lips, 0.8);
    }
    if (own[kShrugUpper] != 0) {
        add(own[kShrugUpper] * soft(q, {0, -40, 98}, {22, 11, 26}), 0, 2.0 * size.lips, 1.4);
    }
    if (own[kPucker] != 0) {
        const double a = own[kPucker];
        d += a * mouth * V3{-0.44 * p.x, 0, 0};
        add(a * soft(q, {0, -43, 96}, {19, 14, 30}), 0, 0, 8.0);
        add(a * corner, 0, 0, 5.5);
        add(a * lips, 0, 0.18 * (p.y - line), 1.2);
        add(a * soft(q, {40, -40, 70}, {13, 18, 30}), -1.4, 0, -1.4);
    }
    if (own[kFunnel] != 0) {
        const double a = own[kFunnel];
        d += a * mouth * V3{-0.30 * p.x, 0, 0};
        add(a * soft(q, {0, -43, 96}, {20, 14, 30}), 0, 0, 6.0);
        add(a * corner, 0, 0, 4.0);
        add(a * upper * soft(q, {0, -39, 98}, {15, 9, 26}), 0, 3.4 * size.lips, 0.8);
        add(a * jaw * soft(q, {0, -48, 98}, {15, 9, 26}), 0, -4.2 * size.lips, 0.8);
    }
    const double roll = std::max(own[kRollLower] * jaw, own[kRollUpper] * upper);
    if (roll != 0) {
        const double red =
            soft(q, {0, line, 97}, {24, 7.5, 26}) * (1 - 0.5 * across * clamp(across, 0, 1));
        d += roll * red * V3{0, -0.42 * (p.y - line), -4.0 * size.lips};
        add(roll * soft(q, {0, -31, 100}, {18, 4.5, 22}), 0, -0.6, 1.0);
        add(roll * soft(q, {0, -58, 94}, {18, 4.5, 22}), 0, 0.6, 1.2);
    }
    return d;
}

// Rolls the lids over the eyeball of one side by `amount` (1: closed but for a slit of 0.5 mm).
void close_eye(const Anatomy& a, const std::vector<V3>& neutral, std::vector<V3>& shape, int side,
               double amount) {
    const double sign = side == 0 ? 1 : -1;
    const V3 rest_centre = a.rest[a.eyeball[side]], centre = neutral[a.eyeball[side]];
    const auto elevation = [](V3 p, V3 c) { return atan2_of(p.y - c.y, p.z - c.z); };
    // Edge of the lids as elevation over template x.
    std::map<double, double> upper, lower, rest_upper, rest_lower;
    for (int v = 0; v < a.count(); ++v) {
        if (a.rest[v].x * sign <= 0 || a.head.rim_row[v] != 0) continue;
        const double x = std::fabs(a.rest[v].x);
        if (a.head.rim[v] == Rim::lid_upper) {
            upper[x] = elevation(neutral[v], centre);
            rest_upper[x] = elevation(a.rest[v], rest_centre);
        } else if (a.head.rim[v] == Rim::lid_lower) {
            lower[x] = elevation(neutral[v], centre);
            rest_lower[x] = elevation(a.rest[v], rest_centre);
        }
    }
    const auto at = [](const std::map<double, double>& curve, double x) {
        const auto above = curve.lower_bound(x);
        if (above == curve.begin()) return above->second;
        if (above == curve.end()) return std::prev(above)->second;
        const auto below = std::prev(above);
        return mix(below->second, above->second,
                   (x - below->first) / (above->first - below->first));
    };
    for (int v = 0; v < a.count(); ++v) {
        const V3 rest = a.rest[v];
        const double x = std::fabs(rest.x);
        if (rest.x * sign <= 0 || rest.z < 60 || x < 10 || x > 56 || rest.y < 8 || rest.y > 46)
            continue;
        const double up = at(upper, x), low = at(lower, x);
        // A slit of half a millimetre stays; it vanishes where the lids meet anyway.
        const double slit = std::min(0.5 / 13.5, std::max(0.0, up - low));
        const double open = std::max(0.0, up - low - slit);
        const double drop = -0.84 * open * amount, lift = 0.16 * open * amount;
        const double r_up = at(rest_upper, x), r_low = at(rest_lower, x);
        const double angle = elevation(rest, rest_centre);
        double turn = 0;
        if (a.head.rim[v] == Rim::lid_upper)
            turn = drop;
        else if (a.head.rim[v] == Rim::lid_lower)
            turn = lift;
        else if (angle > 0.5 * (r_up + r_low))
            turn = drop * ramp(1.15, r_up, angle);
        else
            turn = lift * ramp(-0.95, r_low, angle);
        // Thick skin towards the brow stays where it is.
        turn *= ramp(10, 16.5, x) * ramp(56, 45.5, x) * ramp(21, 15, norm(rest - rest_centre));
        if (turn == 0) continue;
        // Turn about the left-right axis through the eyeball; y towards z is positive downwards.
        shape[v] = centre + rotate(shape[v] - centre, V3{1, 0, 0}, -turn);
    }
}

}  // namespace

const std::vector<std::string>& DemoFaces::expression_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Recipe& r : recipes()) all.push_back(r.name);
        return all;
    }();
    return names;
}

int DemoFaces::expression_index(const std::string& name) {
    const auto& names = expression_names();
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

std::vector<V3> express(const Anatomy& a, const std::vector<V3>& neutral, const Person& person,
                        int expression) {
    std::vector<V3> shape(neutral.begin(), neutral.begin() + a.count());
    if (expression == 0) return shape;
    const Strengths strengths = strengths_of(person, expression);
    const Sizes sizes = sizes_of(a, neutral);
    for (int v = 0; v < a.count(); ++v) {
        const V3 rest = a.rest[v];
        const double left = ramp(-5, 5, rest.x);
        double own[kUnits];
        for (int u = 0; u < kUnits; ++u) own[u] = mix(strengths.right[u], strengths.left[u], left);
        shape[v] += pulls(rest, a.jaw[v], own, sizes);
    }
    // Jaw: opens about the axis through its joints while gliding forward, swings about a vertical
    // axis.
    const V3 joint = 0.5 * (neutral[a.hinge[0]] + neutral[a.hinge[1]]);
    const V3 axis = normalized(neutral[a.hinge[0]] - neutral[a.hinge[1]]);
    const double open = 0.35 * strengths.left[kJawOpen];
    const double swing = 0.085 * (strengths.left[kJawLeft] - strengths.left[kJawRight]);
    const double glide = 6.5 * strengths.left[kJawForward] + 3.0 * strengths.left[kJawOpen];
    if (open != 0 || swing != 0 || glide != 0)
        for (int v = 0; v < a.count(); ++v) {
            const double w = a.jaw[v];
            if (w == 0) continue;
            V3 p = shape[v] - joint;
            p = rotate(p, axis, w * open);
            p = rotate(p, V3{0, 1, 0}, w * swing);
            p.z += w * glide * sizes.face;
            p.y -= w * 0.15 * glide;
            shape[v] = p + joint;
            // Corners of the mouth draw together as it opens.
            const V3 q{std::fabs(a.rest[v].x), a.rest[v].y, a.rest[v].z};
            shape[v].x -=
                7.0 * open * (a.rest[v].x > 0 ? 1 : -1) * soft(q, {26, -44, 82}, {12, 14, 30});
        }
    if (strengths.left[kBlink] != 0)
        close_eye(a, neutral, shape, 0, std::min(1.0, strengths.left[kBlink] + 0.25));
    if (strengths.right[kBlink] != 0)
        close_eye(a, neutral, shape, 1, std::min(1.0, strengths.right[kBlink] + 0.25));
    return shape;
}

}  // namespace mien::demo
