// What makes people differ: soft displacement fields over the template, each at the size of one
// standard deviation, a few of them asymmetric.
#include <cmath>
#include <functional>
#include <iterator>

#include "people.hpp"

namespace mien::demo {
namespace {

double soft(V3 p, V3 c, V3 r) {
    return bump(square((p.x - c.x) / r.x) + square((p.y - c.y) / r.y) + square((p.z - c.z) / r.z));
}

struct Direction {
    const char* name;
    // `p` is a template position, `q` the same with x >= 0, `side` -1..1 softened at the middle.
    V3 (*at)(V3 p, V3 q, double side);
};

constexpr V3 kTip{0, -12, 106}, kMouth{0, -43, 92}, kEye{31, 25, 80}, kEar{78, 1, -12},
    kChin{0, -76, 84};

const Direction kDirections[] = {
    {"size",
     [](V3 p, V3, double) {
         return 0.022 * (p - V3{0, 10, 0});
     }},
    {"head_width",
     [](V3 p, V3, double) {
         return V3{0.026 * p.x, 0, 0};
     }},
    {"head_length",
     [](V3 p, V3, double) {
         return V3{0, 0, -0.045 * std::max(0.0, 50 - p.z)};
     }},
    {"head_height",
     [](V3 p, V3, double) {
         return V3{0, 4.0 * ramp(35, 130, p.y), 0};
     }},
    {"face_length",
     [](V3 p, V3, double) {
         return V3{0, -3.6 * ramp(22, -75, p.y), 0};
     }},
    {"forehead_slope",
     [](V3 p, V3, double) {
         return V3{0, 0, -4.5 * ramp(40, 105, p.y) * ramp(-10, 60, p.z)};
     }},
    {"temple_width",
     [](V3, V3 q, double s) {
         return V3{2.6 * s * soft(q, {66, 48, 40}, {26, 28, 34}), 0, 0};
     }},
    {"brow_ridge",
     [](V3, V3 q, double) {
         return V3{0, 0, 2.2 * soft(q, {22, 43, 88}, {30, 10, 26})};
     }},
    {"brow_height",
     [](V3, V3 q, double) {
         return V3{0, 2.0 * soft(q, {30, 43, 84}, {30, 11, 30}), 0};
     }},
    {"eye_spacing",
     [](V3, V3 q, double s) {
         return V3{1.7 * s * soft(q, kEye, {26, 18, 40}), 0, 0};
     }},
    {"eye_height",
     [](V3, V3 q, double) {
         return V3{0, 1.7 * soft(q, kEye, {32, 16, 40}), 0};
     }},
    {"eye_size",
     [](V3 p, V3 q, double) {
         const double m = 0.075 * soft(q, kEye, {20, 13, 40});
         return V3{m * (q.x - kEye.x) * (p.x < 0 ? -1 : 1), m * (q.y - kEye.y), 0};
     }},
    {"eye_opening",
     [](V3, V3 q, double) {
         return V3{0, 0.10 * (q.y - kEye.y) * soft(q, {31, 25, 84}, {17, 8, 40}), 0};
     }},
    {"eye_slant",
     [](V3, V3 q, double) {
         return V3{0, 1.5 * clamp((q.x - 29) / 16, -1.3, 1.3) * soft(q, kEye, {24, 15, 40}), 0};
     }},
    {"eye_depth",
     [](V3, V3 q, double) {
         return V3{0, 0, -1.9 * soft(q, kEye, {24, 16, 40})};
     }},
    {"nose_length",
     [](V3 p, V3, double) {
         return V3{0, -2.6 * soft(p, kTip, {24, 17, 26}), 0};
     }},
    {"nose_projection",
     [](V3 p, V3, double) {
         return V3{0, 0, 2.8 * soft(p, kTip, {19, 17, 26})};
     }},
    {"nose_width",
     [](V3 p, V3, double) {
         return V3{0.15 * p.x * soft(p, {0, -14, 99}, {22, 13, 22}), 0, 0};
     }},
    {"nose_bridge_height",
     [](V3 p, V3, double) {
         return V3{0, 0, 2.1 * soft(p, {0, 15, 98}, {13, 17, 22})};
     }},
    {"nose_bridge_width",
     [](V3 p, V3, double) {
         return V3{0.14 * p.x * soft(p, {0, 14, 94}, {17, 17, 20}), 0, 0};
     }},
    {"nose_tip_tilt",
     [](V3 p, V3, double) {
         return V3{0, 2.0 * soft(p, {0, -9, 113}, {15, 9, 14}), 0};
     }},
    {"nostril_flare",
     [](V3 p, V3 q, double) {
         return V3{(p.x < 0 ? -1.0 : 1.0) * 1.1 * soft(q, {15, -14, 97}, {7, 8, 13}),
                   0.7 * soft(q, {12, -16, 98}, {8, 7, 13}), 0};
     }},
    {"cheekbone",
     [](V3, V3 q, double s) {
         const double m = soft(q, {50, 2, 62}, {21, 16, 30});
         return V3{2.2 * s * m, 0, 1.3 * m};
     }},
    {"cheek_fullness",
     [](V3, V3 q, double s) {
         const double m = soft(q, {46, -26, 60}, {22, 24, 34});
         return V3{3.0 * s * m, 0, 1.8 * m};
     }},
    {"jaw_width",
     [](V3, V3 q, double s) {
         return V3{3.4 * s * soft(q, {52, -46, 24}, {32, 28, 44}), 0, 0};
     }},
    {"jaw_angle",
     [](V3, V3 q, double) {
         return V3{0, -3.0 * soft(q, {48, -48, 14}, {26, 24, 32}), 0};
     }},
    {"chin_projection",
     [](V3 p, V3, double) {
         return V3{0, 0, 3.4 * soft(p, kChin, {30, 22, 40})};
     }},
    {"chin_height",
     [](V3 p, V3, double) {
         return V3{0, -3.0 * soft(p, {0, -84, 82}, {32, 20, 40}), 0};
     }},
    {"chin_width",
     [](V3 p, V3, double) {
         return V3{0.13 * p.x * soft(p, kChin, {26, 18, 36}), 0, 0};
     }},
    {"mouth_width",
     [](V3 p, V3, double) {
         return V3{0.085 * p.x * soft(p, kMouth, {34, 19, 40}), 0, 0};
     }},
    {"mouth_height",
     [](V3 p, V3, double) {
         return V3{0, 1.9 * soft(p, kMouth, {36, 20, 40}), 0};
     }},
    {"mouth_projection",
     [](V3 p, V3, double) {
         return V3{0, 0, 2.3 * soft(p, kMouth, {32, 22, 40})};
     }},
    {"upper_lip_fullness",
     [](V3 p, V3, double) {
         const double m = soft(p, {0, -39, 98}, {21, 5.5, 22}) * ramp(-44.2, -41, p.y);
         return V3{0, 1.0 * m, 0.8 * m};
     }},
    {"lower_lip_fullness",
     [](V3 p, V3, double) {
         const double m = soft(p, {0, -48, 98}, {20, 6, 22}) * ramp(-42.8, -46, p.y);
         return V3{0, -1.1 * m, 0.8 * m};
     }},
    {"philtrum_depth",
     [](V3 p, V3, double) {
         return V3{0, 0, -0.8 * soft(p, {0, -30, 102}, {4.5, 7, 20})};
     }},
    {"ear_size",
     [](V3 p, V3 q, double) {
         const double m = 0.09 * ramp(70, 78, q.x) * soft(q, kEar, {30, 52, 40});
         return V3{0, m * (p.y - kEar.y), m * (p.z - kEar.z)};
     }},
    {"ear_stand",
     [](V3 p, V3 q, double) {
         const double m = ramp(72, 92, q.x) * ramp(30, 0, p.z) * ramp(-60, -30, p.z);
         return V3{(p.x < 0 ? -2.5 : 2.5) * m, 0, 0};
     }},
    {"neck_width",
     [](V3 p, V3, double) {
         const double m = 0.06 * ramp(-60, -115, p.y);
         return V3{m * p.x, 0, m * (p.z + 15)};
     }},
    {"jaw_skew",
     [](V3 p, V3, double) {
         return V3{1.3 * ramp(-5, -75, p.y) * ramp(-20, 50, p.z) * ramp(-130, -95, p.y), 0, 0};
     }},
    {"nose_skew",
     [](V3 p, V3, double) {
         return V3{1.1 * soft(p, kTip, {20, 20, 28}), 0, 0};
     }},
    {"mouth_skew",
     [](V3 p, V3, double) {
         return V3{0, 0.035 * p.x * soft(p, kMouth, {34, 20, 40}), 0};
     }},
    {"eye_skew",
     [](V3, V3 q, double s) {
         return V3{0, 0.8 * s * soft(q, {31, 32, 82}, {30, 20, 40}), 0};
     }},
    {"cheek_skew",
     [](V3, V3 q, double) {
         return V3{1.1 * soft(q, {48, -20, 58}, {24, 30, 36}), 0, 0};
     }},
};

// Smooth random function of position with unit variance.
struct Waves {
    static constexpr int kCount = 16;
    V3 k[kCount];
    double phase[kCount];
    Waves(Random& random, double wavelength) {
        for (int i = 0; i < kCount; ++i) {
            const V3 d = random.direction();
            k[i] = (2 * kPi / (wavelength * random.uniform(0.7, 1.5))) * d;
            phase[i] = random.uniform(0, 2 * kPi);
        }
    }
    double operator()(V3 p) const {
        double sum = 0;
        for (int i = 0; i < kCount; ++i) sum += cos_of(dot(k[i], p) + phase[i]);
        return sum * std::sqrt(2.0 / kCount);
    }
};

}  // namespace

IdentityBasis make_identity_basis(const Anatomy& anatomy) {
    IdentityBasis basis;
    for (const Direction& direction : kDirections) {
        basis.names.push_back(direction.name);
        std::vector<V3> field;
        field.reserve(anatomy.rest.size());
        for (const V3 p : anatomy.rest) {
            const V3 q{std::fabs(p.x), p.y, p.z};
            field.push_back(direction.at(p, q, p.x / std::sqrt(p.x * p.x + 64)));
        }
        basis.directions.push_back(std::move(field));
    }
    return basis;
}

namespace {

/// x within +-2, nearly as it is within +-1.
double soft_limit(double x) {
    const double e = exp_of(-std::fabs(x));  // tanh(x / 2) = (1 - e^-x) / (1 + e^-x)
    return (x < 0 ? -2 : 2) * (1 - e) / (1 + e);
}

struct Feature {
    V3 centre, radius;  ///< of template positions, x >= 0: it stands on both sides
    double reach_mm;    ///< how far its place moves at one deviation
    double height_mm;   ///< at one deviation
};

// Ridges, hollows and bulges where faces have them.
const Feature kFeatures[kNumPlaces / 3] = {
    {{0, 22, 96}, {6.8, 8.2, 30}, 7.2, 3.1},     {{16, 44, 88}, {10.5, 6, 30}, 9, 2.7},
    {{42, 52, 70}, {11.2, 10.5, 34}, 10.8, 3.1}, {{46, 10, 66}, {10.5, 8.2, 34}, 9.9, 3.4},
    {{34, -4, 78}, {9, 8.2, 30}, 9, 3.1},        {{24, -30, 84}, {7.5, 9, 30}, 8.1, 2.7},
    {{0, -76, 84}, {9, 6.8, 30}, 9, 3.4},        {{18, -78, 76}, {9, 6.8, 32}, 9, 2.7},
    {{46, -46, 52}, {12, 10.5, 36}, 11.7, 3.4},  {{62, -20, 30}, {12, 12, 36}, 11.7, 3.1},
    {{0, 80, 84}, {16.5, 11.2, 36}, 14.4, 3.1},  {{34, 84, 70}, {15, 11.2, 38}, 12.6, 2.7}};

/// A feature does not grow where it is: it wanders, and its height goes up and down with where it
/// has gone. In a span of fixed directions one wandering feature takes many.
void add_features(const Anatomy& anatomy, const Person& person, std::vector<V3>& shape) {
    const std::size_t count = person.places.size() / 3;
    for (std::size_t f = 0; f < count && f < std::size(kFeatures); ++f) {
        const Feature& feature = kFeatures[f];
        const double across = soft_limit(person.places[3 * f]),
                     along = soft_limit(person.places[3 * f + 1]), size = person.places[3 * f + 2];
        V3 centre = feature.centre;
        if (centre.x > 0) centre.x += feature.reach_mm * across;
        centre.y += feature.reach_mm * along;
        const V3 radius = (1 + 0.2 * sin_of(1.5 * size + across)) * feature.radius;
        const double height = feature.height_mm * (1.2 * sin_of(1.1 * size) + 0.6 * across * along);
        for (int v = 0; v < anatomy.count(); ++v) {
            const V3 p = anatomy.rest[v], q{std::fabs(p.x), p.y, p.z};
            shape[v] += height * soft(q, centre, radius) * anatomy.normals[v];
        }
    }
}

}  // namespace

std::vector<V3> neutral_shape(const Anatomy& anatomy, const IdentityBasis& basis,
                              const Person& person) {
    std::vector<V3> shape = anatomy.rest;
    const bool nonlinear = !person.places.empty();
    for (std::size_t k = 0; k < basis.directions.size() && k < person.weights.size(); ++k) {
        const double weight = nonlinear ? soft_limit(person.weights[k]) : person.weights[k];
        if (weight == 0) continue;
        for (std::size_t v = 0; v < shape.size(); ++v) shape[v] += weight * basis.directions[k][v];
    }
    if (nonlinear) add_features(anatomy, person, shape);
    // Detail that is nobody else's, faded out where skin is thin (lids, lips).
    if (person.detail_mm > 0) {
        Random random(person.seed, 1000003u * static_cast<std::uint64_t>(person.subject) + 17);
        const Waves broad(random, 42), fine(random, 17);
        for (int v = 0; v < anatomy.count(); ++v) {
            const V3 p = anatomy.rest[v], q{std::fabs(p.x), p.y, p.z};
            const double thin =
                std::max(soft(q, {31, 25, 80}, {22, 13, 30}), soft(p, {0, -43, 92}, {32, 13, 30}));
            const double height =
                person.detail_mm * (1 - 0.9 * thin) * (1.6 * broad(p) + 0.6 * fine(p));
            shape[v] += height * anatomy.normals[v];
        }
    }
    return shape;
}

}  // namespace mien::demo
