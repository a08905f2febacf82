// The face generator: a clean template, people who differ, expressions that move what they should.
#include "demo_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace {

using mien::demo::DemoFaces;
using mien::demo::FaceMesh;
using mien::demo::Person;
using mien::demo::ScanOptions;

const DemoFaces& faces() {
    static const DemoFaces made;
    return made;
}

using Vec = std::array<double, 3>;
Vec at(const std::vector<double>& x, std::size_t v) {
    return {x[3 * v], x[3 * v + 1], x[3 * v + 2]};
}
Vec minus(const Vec& a, const Vec& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double norm(const Vec& a) {
    return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}
double dot(const Vec& a, const Vec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec normal(const std::vector<double>& x, const std::vector<std::uint32_t>& triangles,
           std::size_t t) {
    const Vec a = at(x, triangles[3 * t]);
    return cross(minus(at(x, triangles[3 * t + 1]), a), minus(at(x, triangles[3 * t + 2]), a));
}
std::size_t landmark(const std::string& name) {
    for (const auto& [known, vertex] : faces().landmarks())
        if (known == name) return vertex;
    ADD_FAILURE() << name;
    return 0;
}
Person average() {
    Person person = faces().person(1, 0);
    std::fill(person.weights.begin(), person.weights.end(), 0.0);
    person.liveliness = 1;
    person.detail_mm = 0;
    return person;
}
std::vector<double> face(const Person& person, const std::string& expression) {
    return faces().face(person, DemoFaces::expression_index(expression));
}

std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    const auto& t = faces().template_mesh().triangles;
    for (std::size_t k = 0; k < t.size(); k += 3)
        for (std::size_t i = 0; i < 3; ++i) ++edges[{t[k + i], t[k + (i + 1) % 3]}];
    return edges;
}

TEST(DemoTemplate, IsAnOrientedManifoldWithFourBorders) {
    const auto edges = directed_edges();
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& [edge, uses] : edges) {
        EXPECT_EQ(uses, 1);
        if (edges.count({edge.second, edge.first}) == 0) {
            EXPECT_EQ(next.count(edge.first), 0u) << "two borders meet in vertex " << edge.first;
            next[edge.first] = edge.second;
        }
    }
    int loops = 0;
    std::set<std::uint32_t> seen;
    for (const auto& [start, unused] : next) {
        if (seen.count(start) != 0) continue;
        ++loops;
        for (std::uint32_t v = start; seen.insert(v).second; v = next.at(v)) {
        }
    }
    EXPECT_EQ(loops, 4);  // two eyes, mouth, neck
    std::set<std::uint32_t> used;
    for (const auto& [edge, uses] : edges) used.insert(edge.first);
    const std::size_t count = faces().template_mesh().vertices.size() / 3;
    EXPECT_EQ(used.size(), count);
    // Euler: a sphere with four holes and no handle.
    const std::size_t triangles = faces().template_mesh().triangles.size() / 3;
    const std::size_t undirected = (edges.size() + next.size()) / 2;
    EXPECT_EQ(
        static_cast<long>(count) - static_cast<long>(undirected) + static_cast<long>(triangles),
        -2);
}

TEST(DemoTemplate, HasTheSizeOfAHeadAndWellShapedTriangles) {
    const FaceMesh& mesh = faces().template_mesh();
    const std::size_t count = mesh.vertices.size() / 3;
    EXPECT_GE(count, 8000u);
    EXPECT_LE(count, 12000u);
    double low = 1e9, high = -1e9;
    for (std::size_t v = 0; v < count; ++v) {
        low = std::min(low, at(mesh.vertices, v)[1]);
        high = std::max(high, at(mesh.vertices, v)[1]);
    }
    EXPECT_GT(high - low, 200);
    EXPECT_LT(high - low, 350);
    std::vector<double> smallest;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        double least = 180;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec p = at(mesh.vertices, mesh.triangles[t + k]);
            const Vec a = minus(at(mesh.vertices, mesh.triangles[t + (k + 1) % 3]), p);
            const Vec b = minus(at(mesh.vertices, mesh.triangles[t + (k + 2) % 3]), p);
            least =
                std::min(least, std::atan2(norm(cross(a, b)), dot(a, b)) * 180 / std::acos(-1.0));
        }
        smallest.push_back(least);
    }
    std::sort(smallest.begin(), smallest.end());
    EXPECT_GT(smallest.front(), 10);
    EXPECT_GT(smallest[smallest.size() / 100], 20);
    EXPECT_GT(smallest[smallest.size() / 2], 45);
}

TEST(DemoTemplate, IsMirrorSymmetricToTheBit) {
    const FaceMesh& mesh = faces().template_mesh();
    for (std::size_t v = 0; v < faces().mirror().size(); ++v) {
        const std::size_t m = faces().mirror()[v];
        ASSERT_EQ(faces().mirror()[m], v);
        const Vec a = at(mesh.vertices, v), b = at(mesh.vertices, m);
        ASSERT_EQ(a[0], -b[0]);
        ASSERT_EQ(a[1], b[1]);
        ASSERT_EQ(a[2], b[2]);
    }
}

TEST(DemoTemplate, HasLandmarksWhereTheyBelong) {
    EXPECT_EQ(faces().landmarks().size(), 68u);
    std::set<std::uint32_t> different;
    for (const auto& [name, vertex] : faces().landmarks()) different.insert(vertex);
    EXPECT_EQ(different.size(), 68u);
    const auto& x = faces().template_mesh().vertices;
    const auto mark = [&](const char* name) { return at(x, landmark(name)); };
    EXPECT_GT(mark("eye_left_3")[0], mark("eye_left_0")[0]);  // the subject's left is +x
    EXPECT_GT(mark("eye_left_0")[0], 0);
    EXPECT_LT(mark("eye_right_0")[0], mark("eye_right_3")[0]);
    EXPECT_GT(mark("nose_bridge_3")[2], mark("nose_bridge_0")[2]);
    EXPECT_GT(mark("mouth_outer_03")[1], mark("mouth_inner_2")[1]);
    EXPECT_GT(mark("mouth_inner_2")[1], mark("mouth_inner_6")[1]);
    EXPECT_GT(mark("mouth_outer_09")[1], mark("jaw_08")[1]);
    EXPECT_GT(mark("jaw_16")[0], 55);
    EXPECT_NEAR(mark("jaw_08")[0], 0, 1e-12);
    EXPECT_GT(mark("brow_left_2")[1], mark("eye_left_1")[1]);
}

TEST(DemoTemplate, ZonesAreDisjointPartsOfTheFace) {
    std::set<std::uint32_t> all, face_zone;
    for (const auto& [name, members] : faces().zones()) {
        EXPECT_GT(members.size(), 50u) << name;
        if (name == "face") {
            face_zone.insert(members.begin(), members.end());
            continue;
        }
        for (std::uint32_t v : members) {
            EXPECT_TRUE(all.insert(v).second) << name << " shares vertex " << v;
            EXPECT_EQ(face_zone.count(v), 1u) << name << ", vertex " << v;
        }
    }
    EXPECT_EQ(faces().zones().size(), 11u);
    EXPECT_EQ(faces().zones().front().first, "face");
}

TEST(DemoTemplate, LipsAreFarApartAlongTheSkinThoughNearInSpace) {
    const std::size_t upper = landmark("mouth_inner_2"), lower = landmark("mouth_inner_6");
    const FaceMesh& mesh = faces().template_mesh();
    const double gap = norm(minus(at(mesh.vertices, upper), at(mesh.vertices, lower)));
    EXPECT_LT(gap, 2.0);
    // Dijkstra by repeated relaxation over edges.
    std::vector<double> distance(mesh.vertices.size() / 3, 1e18);
    distance[upper] = 0;
    const auto edges = directed_edges();
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [edge, uses] : edges) {
            const auto [a, b] = edge;
            const double length = norm(minus(at(mesh.vertices, a), at(mesh.vertices, b)));
            for (const auto& [u, v] : {std::pair{a, b}, std::pair{b, a}})
                if (distance[u] + length < distance[v] - 1e-9) {
                    distance[v] = distance[u] + length;
                    changed = true;
                }
        }
    }
    EXPECT_GT(distance[lower], 45);
}

TEST(DemoPeople, SameSeedGivesTheSameBitsAndOthersDiffer) {
    const auto a = face(faces().person(3, 5), "grin");
    const DemoFaces again;
    EXPECT_EQ(again.template_mesh().vertices, faces().template_mesh().vertices);
    EXPECT_EQ(again.face(again.person(3, 5), DemoFaces::expression_index("grin")), a);
    EXPECT_NE(face(faces().person(3, 6), "grin"), a);
    EXPECT_NE(face(faces().person(4, 5), "grin"), a);
}

TEST(DemoPeople, IdentityDirectionsAreManyAndIndependent) {
    const int count = static_cast<int>(faces().identity_names().size());
    EXPECT_GE(count, 20);
    std::vector<std::vector<double>> kept;
    for (int k = 0; k < count; ++k) {  // Gram-Schmidt
        std::vector<double> d = faces().identity_direction(k);
        double before = 0, after = 0;
        for (double v : d) before += v * v;
        for (const auto& basis : kept) {
            double along = 0;
            for (std::size_t i = 0; i < d.size(); ++i) along += d[i] * basis[i];
            for (std::size_t i = 0; i < d.size(); ++i) d[i] -= along * basis[i];
        }
        for (double v : d) after += v * v;
        EXPECT_GT(after, 0.02 * before) << faces().identity_names()[static_cast<std::size_t>(k)];
        for (double& v : d) v /= std::sqrt(after);
        kept.push_back(std::move(d));
    }
}

/// Share of ten people's shapes that lies outside of what ninety others of their family span.
double share_outside(bool nonlinear) {
    const auto& rest = faces().template_mesh().vertices;
    const auto shape = [&](int subject) {
        const Person person =
            nonlinear ? faces().nonlinear_person(11, subject) : faces().person(11, subject);
        std::vector<double> d = faces().face(DemoFaces::without_chance(person), 0);
        for (std::size_t i = 0; i < d.size(); ++i) d[i] -= rest[i];
        return d;
    };
    const auto length = [](const std::vector<double>& d) {
        double sum = 0;
        for (const double v : d) sum += v * v;
        return std::sqrt(sum);
    };
    std::vector<std::vector<double>> kept;
    double outside = 0, whole = 0;
    for (int subject = 0; subject < 100; ++subject) {  // Gram-Schmidt
        std::vector<double> d = shape(subject);
        const double size = length(d);
        for (const auto& basis : kept) {
            double along = 0;
            for (std::size_t i = 0; i < d.size(); ++i) along += d[i] * basis[i];
            for (std::size_t i = 0; i < d.size(); ++i) d[i] -= along * basis[i];
        }
        const double left = length(d);
        if (subject >= 90) {
            outside += left;
            whole += size;
        } else if (left > 1e-6 * size) {
            for (double& v : d) v /= left;
            kept.push_back(std::move(d));
        }
    }
    return outside / whole;
}

TEST(DemoPeople, ThoseOfTheNonlinearFamilyAreNoSumsOfFixedDirections) {
    EXPECT_LT(share_outside(false), 1e-6);
    EXPECT_GT(share_outside(true), 0.02);
}

TEST(DemoExpressions, OfTheNonlinearFamilyAreFunctionsOfThePersonButForStatedChance) {
    const int grin = DemoFaces::expression_index("grin");
    const Person one = faces().nonlinear_person(3, 5);
    EXPECT_EQ(faces().nonlinear_person(3, 5).places, one.places);
    EXPECT_NE(faces().nonlinear_person(3, 6).places, one.places);
    // Who has the same numbers and no chance has the same face, whatever the subject's number.
    Person twin = DemoFaces::without_chance(one), other = twin;
    other.subject = 77;
    EXPECT_EQ(faces().face(twin, grin), faces().face(other, grin));
    const auto neutral = faces().face(twin, 0), sure = faces().face(twin, grin);
    twin.strength_noise = one.strength_noise;
    const auto chance = faces().face(twin, grin);
    double moved = 0, noise = 0;
    for (std::size_t i = 0; i < neutral.size(); ++i) {
        moved += std::fabs(sure[i] - neutral[i]);
        noise += std::fabs(chance[i] - sure[i]);
    }
    EXPECT_GT(noise, 0);
    EXPECT_LT(noise, 0.1 * moved);
}

TEST(DemoExpressions, MoveWhatTheyShouldAndLeaveTheRest) {
    const Person person = average();
    const auto neutral = face(person, "neutral");
    EXPECT_EQ(neutral, faces().template_mesh().vertices);
    const auto move = [&](const char* expression, const char* mark) {
        return minus(at(face(person, expression), landmark(mark)), at(neutral, landmark(mark)));
    };
    EXPECT_LT(move("mouth_stretch", "jaw_08")[1], -12);  // chin goes down
    EXPECT_LT(norm(move("mouth_stretch", "nose_bridge_1")), 0.8);
    EXPECT_GT(move("smile", "mouth_outer_06")[1], 2);  // corners up and apart
    EXPECT_GT(move("smile", "mouth_outer_06")[0], 2);
    EXPECT_LT(move("smile", "mouth_outer_00")[0], -2);
    EXPECT_LT(move("sadness", "mouth_outer_06")[1], -2);
    EXPECT_GT(move("brow_raiser", "brow_left_2")[1], 2);
    EXPECT_LT(move("brow_lower", "brow_right_3")[1], -2);
    EXPECT_GT(move("jaw_left", "jaw_08")[0], 3);
    EXPECT_LT(move("jaw_right", "jaw_08")[0], -3);
    EXPECT_GT(move("jaw_forward", "jaw_08")[2], 3);
    EXPECT_GT(move("mouth_left", "mouth_outer_03")[0], 3);
    EXPECT_LT(move("lip_puckerer", "mouth_outer_06")[0], -5);
    EXPECT_GT(move("lip_puckerer", "mouth_outer_03")[2], 3);
    EXPECT_LT(move("lip_roll", "mouth_outer_09")[2], -0.5);
    EXPECT_GT(norm(move("cheek_blowing", "mouth_outer_06")), 0.2);
    for (const std::string& name : DemoFaces::expression_names()) {
        if (name.find("brow") != std::string::npos || name == "anger" || name == "sadness")
            continue;
        EXPECT_LT(std::fabs(move(name.c_str(), "nose_bridge_0")[1]), 1.0) << name;
    }
}

TEST(DemoExpressions, LidsCloseToASlitWithoutCrossing) {
    for (int subject = 0; subject < 8; ++subject) {
        const auto closed = face(faces().person(2, subject), "eyes_closed");
        const auto open = face(faces().person(2, subject), "neutral");
        for (const char* side : {"left", "right"})
            for (const auto& [upper, lower] : {std::pair{"1", "5"}, std::pair{"2", "4"}}) {
                const std::string stem = std::string("eye_") + side + "_";
                const std::size_t u = landmark(stem + upper), l = landmark(stem + lower);
                const double gap = at(closed, u)[1] - at(closed, l)[1];
                EXPECT_GT(gap, 0) << subject << " " << stem << upper;
                EXPECT_LT(gap, 0.45 * (at(open, u)[1] - at(open, l)[1]))
                    << subject << " " << stem << upper;
            }
    }
}

TEST(DemoExpressions, DoNotFoldTheSkin) {
    const auto& triangles = faces().template_mesh().triangles;
    for (int subject = 0; subject < 5; ++subject) {
        const Person person = faces().person(1, subject);
        const auto neutral = face(person, "neutral");
        int folded = 0;
        for (const std::string& name : DemoFaces::expression_names()) {
            const auto x = face(person, name);
            for (double v : x) ASSERT_TRUE(std::isfinite(v));
            for (std::size_t t = 0; t < triangles.size() / 3; ++t)
                folded += dot(normal(x, triangles, t), normal(neutral, triangles, t)) < 0;
        }
        EXPECT_LT(folded, 40) << "subject " << subject;  // of 20 x 19,000
    }
}

TEST(DemoExpressions, DependOnThePersonBeyondABilinearModel) {
    // Were expressions one shape scaled by a number per person, two people's displacements would be
    // parallel.
    const auto field = [](int subject) {
        const Person person = faces().person(1, subject);
        const auto a = face(person, "grin"), b = face(person, "neutral");
        std::vector<double> d(a.size());
        for (std::size_t k = 0; k < d.size(); ++k) d[k] = a[k] - b[k];
        return d;
    };
    const auto a = field(1), b = field(2);
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        ab += a[k] * b[k];
        aa += a[k] * a[k];
        bb += b[k] * b[k];
    }
    const double cosine = ab / std::sqrt(aa * bb);
    EXPECT_GT(cosine, 0.8);
    EXPECT_LT(cosine, 0.998);
}

TEST(DemoExpressions, AnUnknownOneGivesNothing) {
    EXPECT_EQ(DemoFaces::expression_index("no such thing"), -1);
    EXPECT_TRUE(faces().face(faces().person(1, 1), -1).empty());
    EXPECT_TRUE(faces().face(faces().person(1, 1), 20).empty());
}

TEST(DemoScan, ShowsTheTrueFaceWhereItSaysSo) {
    ScanOptions options;
    options.noise_mm = 0;
    options.spike_share = 0;
    options.step_mm = 1.5;
    const auto scan =
        faces().scan(faces().person(1, 3), DemoFaces::expression_index("grin"), options);
    const std::size_t points = scan.mesh.vertices.size() / 3;
    ASSERT_GT(points, 20000u);
    ASSERT_EQ(scan.mesh.colors.size(), scan.mesh.vertices.size());
    for (std::uint32_t v : scan.mesh.triangles) ASSERT_LT(v, points);
    std::size_t seen = 0, checked = 0;
    for (std::size_t v = 0; v < scan.visible.size(); ++v) {
        seen += scan.visible[v];
        if (!scan.visible[v] || v % 37 != 0) continue;
        double nearest = 1e18;
        for (std::size_t p = 0; p < points; ++p)
            nearest = std::min(nearest, norm(minus(at(scan.mesh.vertices, p), at(scan.truth, v))));
        EXPECT_LT(nearest, 4.0) << v;  // points lie farther apart than the step where skin is steep
        ++checked;
    }
    EXPECT_GT(checked, 50u);
    EXPECT_GT(seen, scan.visible.size() / 3);
    EXPECT_LT(seen, scan.visible.size());
}

TEST(DemoScan, LiesInAFrameOfItsOwnAndKeepsItBetweenExpressions) {
    const Person person = faces().person(1, 4);
    ScanOptions options;
    options.step_mm = 3;
    const auto grin = faces().scan(person, DemoFaces::expression_index("grin"), options);
    const auto neutral = faces().scan(person, 0, options);
    EXPECT_EQ(grin.rotation, neutral.rotation);
    EXPECT_EQ(grin.truth_neutral, neutral.truth);
    const auto head = faces().face(person, DemoFaces::expression_index("grin"));
    for (std::size_t v = 0; v < head.size() / 3; v += 101) {
        const Vec p = at(head, v), q = at(grin.truth, v);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(grin.rotation[3 * k] * p[0] + grin.rotation[3 * k + 1] * p[1] +
                            grin.rotation[3 * k + 2] * p[2] + grin.translation[k],
                        q[k], 1e-9);
    }
    options.seed = 9;
    EXPECT_NE(faces().scan(person, 0, options).rotation, neutral.rotation);
}

}  // namespace
