#include "measure/anthropometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <set>

#include "measure/norms.hpp"
#include "measure/random.hpp"
#include "shapes.hpp"

namespace mien {
namespace {

FacePlace at(const char* name, double x, double y, double z) {
    return {name, -1, Vector3(x, y, z)};
}

/// A profile whose numbers can be worked out by hand, mm; +x left, +y up, +z forward.
std::vector<FacePlace> square_profile() {
    return {at("glabella", 0, 60, 100),
            at("nasion", 0, 40, 100),
            at("pronasale", 0, 0, 140),
            at("columella", 0, -10, 130),
            at("subnasale", 0, -10, 110),
            at("labiale_superius", 0, -30, 110),
            at("stomion", 0, -40, 110),
            at("labiale_inferius", 0, -50, 115),
            at("pogonion", 0, -70, 110),
            at("gnathion", 0, -80, 100),
            at("exocanthion_right", -50, 30, 80),
            at("exocanthion_left", 50, 30, 80),
            at("endocanthion_right", -15, 30, 90),
            at("endocanthion_left", 15, 25, 90),
            at("cheilion_right", -25, -40, 100),
            at("cheilion_left", 25, -35, 100)};
}

/// A surface that the places do not lie on.
TriMesh somewhere() {
    return test::grid(10, 10, 2, 2);
}

AnthropometricValue value_named(const std::vector<AnthropometricValue>& values, const char* name) {
    for (const AnthropometricValue& value : values)
        if (std::string(value.definition->name) == name) return value;
    ADD_FAILURE() << "no measurement " << name;
    return {};
}

std::vector<FacePlace> moved(std::vector<FacePlace> places, const Similarity& motion) {
    for (FacePlace& place : places) place.point = motion.apply(place.point);
    return places;
}

TEST(Anthropometry, KnownProfileGivesItsLengthsAnglesAndProportions) {
    const auto values = measure_anthropometry(somewhere(), square_profile(), {}, {});
    const auto value = [&](const char* name) { return value_named(values, name).value; };
    EXPECT_NEAR(value("n-gn"), 120.0, 1e-12);
    EXPECT_NEAR(value("ex-ex"), 100.0, 1e-12);
    EXPECT_NEAR(value("lower face index"), 100 * std::hypot(70.0, 10.0) / 120.0, 1e-12);
    EXPECT_NEAR(value("nasolabial"), 90.0, 1e-12);
    EXPECT_NEAR(value("nasofrontal"), 135.0, 1e-12);
    // Along -y, -z: the tip lies 40 below and 40 in front of nasion.
    EXPECT_NEAR(value("nasofacial"), 45.0 - std::atan2(10.0, 130.0) * 180 / M_PI, 1e-9);
    // g-sn goes 10 forward in 70, sn-pg straight down.
    EXPECT_NEAR(value("convexity"), std::atan2(10.0, 70.0) * 180 / M_PI, 1e-9);
    // The line tip to chin passes (y -50) at z 140 - 30 * 50 / 70.
    const double line = 140 - 30.0 * 50 / 70, steep = std::atan2(30.0, 70.0);
    EXPECT_NEAR(value("li E line"), (115 - line) * std::cos(steep), 1e-9);
    EXPECT_NEAR(value("ls B line"), 0.0, 1e-9);
}

TEST(Anthropometry, InclinationsAreSignedAndSeenFromTheFront) {
    const auto values = measure_anthropometry(somewhere(), square_profile(), {}, {});
    // The left corner of the mouth is 5 higher over 50.
    EXPECT_NEAR(value_named(values, "mouth cant").value, std::atan2(5.0, 50.0) * 180 / M_PI, 0.1);
    // Both outer corners lie at y 30; the inner ones at 30 (right) and 25 (left).
    EXPECT_GT(value_named(values, "canthal tilt_left").value, 5.0);
    auto lower = square_profile();
    for (FacePlace& place : lower)
        if (place.name == "cheilion_left") place.point.y() = -45;
    EXPECT_LT(value_named(measure_anthropometry(somewhere(), lower, {}, {}), "mouth cant").value,
              -5.0);
}

TEST(Anthropometry, DoesNotChangeUnderRigidMotionAndScalesWithTheFace) {
    Similarity motion;
    motion.rotation = Eigen::AngleAxisd(1.1, Vector3(1, 2, -1).normalized()).toRotationMatrix();
    motion.translation = Vector3(500, -20, 33);
    const auto before = measure_anthropometry(somewhere(), square_profile(), {}, {});
    const auto turned = measure_anthropometry(somewhere(), moved(square_profile(), motion), {}, {});
    motion.scale = 1.25;
    const auto grown = measure_anthropometry(somewhere(), moved(square_profile(), motion), {}, {});
    int compared = 0;
    for (std::size_t k = 0; k < before.size(); ++k) {
        if (!before[k].reason.empty()) continue;
        ++compared;
        EXPECT_NEAR(turned[k].value, before[k].value, 1e-9) << before[k].definition->name;
        const bool length = std::string(unit_of(before[k].definition->kind)) == "mm";
        EXPECT_NEAR(grown[k].value, (length ? 1.25 : 1.0) * before[k].value, 1e-9)
            << before[k].definition->name;
    }
    EXPECT_GT(compared, 35);
}

TEST(Anthropometry, WhatLacksItsLandmarksIsNoNumberAndSaysWhich) {
    const auto values = measure_anthropometry(somewhere(), square_profile(), {}, {});
    const AnthropometricValue width = value_named(values, "zy-zy");
    EXPECT_TRUE(std::isnan(width.value));
    EXPECT_EQ(width.reason, "the face has no landmark zygion_right, zygion_left");
    const AnthropometricValue along = value_named(values, "sn-gn surface");
    EXPECT_TRUE(std::isnan(along.value));
    EXPECT_NE(along.reason.find("no vertex"), std::string::npos);
}

std::vector<FacePlace> the_68(double spread) {
    std::vector<FacePlace> places;
    struct Part {
        const char* name;
        int count;
    };
    SplitMix chance(5);
    for (const Part& part :
         {Part{"jaw_", 17}, Part{"brow_right_", 5}, Part{"brow_left_", 5}, Part{"nose_bridge_", 4},
          Part{"nose_base_", 5}, Part{"eye_right_", 6}, Part{"eye_left_", 6},
          Part{"mouth_outer_", 12}, Part{"mouth_inner_", 8}})
        for (int k = 0; k < part.count; ++k)
            places.push_back({part.name + std::to_string(k), -1,
                              Vector3(spread * chance.normal(), spread * chance.normal(),
                                      spread * chance.normal())});
    return places;
}

TEST(Anthropometry, NumberedPointsStandForAnatomyWhereTheyCoincide) {
    const auto places = the_68(50);
    const auto found = find_anatomical_places(places);
    std::set<std::string> known;
    std::size_t stomion = 0;
    for (std::size_t k = 0; k < found.size(); ++k)
        if (!found[k].places.empty()) {
            known.insert(anatomical_landmarks()[k].name);
            if (anatomical_landmarks()[k].name == "stomion") stomion = k;
        }
    EXPECT_TRUE(known.count("gnathion") && known.count("pronasale") &&
                known.count("cheilion_left"));
    // Neighbours only: under the nostrils, beside the root of the nose, along the outline.
    for (const char* name :
         {"alare_right", "subalare_left", "nasion", "tragion_left", "zygion_left"})
        EXPECT_FALSE(known.count(name)) << name;
    ASSERT_EQ(found[stomion].places.size(), 2u);
    EXPECT_EQ(found[stomion].from, "mouth_inner_2 and mouth_inner_6");
    // A name of the field's own comes first, in any spelling.
    auto more = places;
    more.push_back(at("Left-Cheilion", 1, 2, 3));
    for (std::size_t k = 0; k < found.size(); ++k)
        if (anatomical_landmarks()[k].name == "cheilion_left") {
            EXPECT_EQ(find_anatomical_places(more)[k].from, "Left-Cheilion");
        }
    int measured = 0;
    for (const AnthropometricValue& value : measure_anthropometry(somewhere(), places, {}, {}))
        measured += value.reason.empty() ? 1 : 0;
    EXPECT_GE(measured, 35);
}

TEST(Anthropometry, TableIsWhole) {
    std::set<std::string> names, landmarks;
    for (const AnatomicalLandmark& one : anatomical_landmarks()) {
        EXPECT_TRUE(landmarks.insert(one.name).second) << one.name;
        EXPECT_TRUE(landmarks.insert(one.abbreviation).second) << one.abbreviation;
    }
    for (const AnthropometricDefinition& one : anthropometric_definitions()) {
        EXPECT_TRUE(names.insert(one.name).second) << one.name;
        for (int k = 0; k < mark_count(one.kind); ++k) {
            const char* mark = one.marks[static_cast<std::size_t>(k)];
            ASSERT_NE(mark, nullptr) << one.name;
            EXPECT_TRUE(landmarks.count(mark)) << one.name << ": " << mark;
        }
        EXPECT_NE(std::string(one.source), "") << one.name;
    }
    EXPECT_GE(names.size(), 40u);
}

/// A bent sheet with the landmarks of square_profile() as vertices of their own.
struct Sheet {
    TriMesh face = test::sphere(90, 4);
    std::vector<FacePlace> places = square_profile();
    AnthropometryErrors errors;
    Sheet() {
        std::set<Index> taken;
        for (FacePlace& place : places) {
            Index best = -1;
            double nearest = HUGE_VAL;
            for (Index v = 0; v < face.vertices.rows(); ++v) {
                const double d = (face.vertices.row(v).transpose() - place.point).norm();
                if (d < nearest && taken.count(v) == 0) nearest = d, best = v;
            }
            taken.insert(best);
            place.vertex = best;
        }
        errors.place_sd_mm = Vector::Constant(face.vertices.rows(), 0.4);
        errors.normal_sd_mm = Vector::Constant(face.vertices.rows(), 0.15);
        for (Index v = 0; v < face.vertices.rows(); ++v)
            errors.place_sd_mm[v] += 0.1 * std::sin(double(v));
    }
};

TEST(Anthropometry, DeviationsAgreeWithDrawsOfTheErrorModel) {
    const Sheet sheet;
    const auto stated = measure_anthropometry(sheet.face, sheet.places, sheet.errors, {});
    const auto n = static_cast<Index>(sheet.places.size());
    // The landmarks' errors: two correlated fields along the tangent plane, one along the normal.
    Points x(n, 3);
    for (Index i = 0; i < n; ++i)
        x.row(i) = sheet.face.vertices.row(sheet.places[static_cast<std::size_t>(i)].vertex);
    const auto factor = [&](double length) {
        Matrix c(n, n);
        for (Index i = 0; i < n; ++i)
            for (Index j = 0; j < n; ++j)
                c(i, j) = std::exp(-(x.row(i) - x.row(j)).squaredNorm() / (2 * length * length)) +
                          (i == j ? 1e-12 : 0.0);
        return Matrix(Eigen::LLT<Matrix>(c).matrixL());
    };
    const Matrix slide = factor(sheet.errors.slide_correlation_mm),
                 across = factor(sheet.errors.normal_correlation_mm);
    SplitMix chance(3);
    const auto field = [&](const Matrix& l) {
        Vector white(n);
        for (Index i = 0; i < n; ++i) white[i] = chance.normal();
        return Vector(l * white);
    };
    constexpr int kDraws = 6000;
    std::vector<double> sum(stated.size(), 0.0), squares(stated.size(), 0.0);
    for (int draw = 0; draw < kDraws; ++draw) {
        const Vector a = field(slide), b = field(slide), c = field(slide), d = field(across);
        auto places = sheet.places;
        for (Index i = 0; i < n; ++i) {
            FacePlace& place = places[static_cast<std::size_t>(i)];
            const Vector3 normal = x.row(i).normalized().transpose();
            const double s = sheet.errors.place_sd_mm[place.vertex],
                         sn = sheet.errors.normal_sd_mm[place.vertex],
                         st = std::sqrt(0.5 * (3 * s * s - sn * sn));
            Vector3 along(a[i], b[i], c[i]);
            along -= normal.dot(along) * normal;
            place.point = x.row(i).transpose() + st * along + sn * d[i] * normal;
            place.vertex = -1;
        }
        const auto drawn = measure_anthropometry(somewhere(), places, {}, {});
        for (std::size_t k = 0; k < drawn.size(); ++k) {
            if (!drawn[k].reason.empty()) continue;
            const double off = drawn[k].value - stated[k].value;
            sum[k] += off;
            squares[k] += off * off;
        }
    }
    int compared = 0;
    for (std::size_t k = 0; k < stated.size(); ++k) {
        if (!(squares[k] > 0)) continue;
        ++compared;
        const double mean = sum[k] / kDraws, sd = std::sqrt(squares[k] / kDraws - mean * mean);
        EXPECT_NEAR(stated[k].sd, sd, 0.07 * sd) << stated[k].definition->name;
    }
    EXPECT_GT(compared, 35);
}

TEST(Anthropometry, LandmarksThatSlideTogetherKeepTheirLength) {
    Sheet sheet;
    sheet.errors.normal_sd_mm.setZero();
    sheet.errors.slide_correlation_mm = 1e6;  // the whole template slides as one
    const auto stiff = measure_anthropometry(sheet.face, sheet.places, sheet.errors, {});
    sheet.errors.slide_correlation_mm = 0;
    const auto loose = measure_anthropometry(sheet.face, sheet.places, sheet.errors, {});
    EXPECT_LT(value_named(stiff, "ls-li").sd, 0.3 * value_named(loose, "ls-li").sd);
}

TEST(Anthropometry, SurfaceLengthsFollowTheSphere) {
    Sheet sheet;
    const auto values = measure_anthropometry(sheet.face, sheet.places, sheet.errors, {});
    const AnthropometricValue along = value_named(values, "sn-gn surface");
    const AnthropometricValue straight = value_named(values, "sn-gn");
    const double arc = 2 * 90 * std::asin(straight.value / 180);
    EXPECT_NEAR(along.value, arc, 0.015 * arc);
    // The ends slide along the way; across it they change nothing.
    EXPECT_GT(along.sd, 0.2);
    EXPECT_LT(along.sd, 1.2);
    sheet.errors.place_sd_mm.resize(0);
    const auto unknown = measure_anthropometry(sheet.face, sheet.places, sheet.errors, {});
    EXPECT_TRUE(std::isnan(value_named(unknown, "sn-gn surface").sd));
    EXPECT_TRUE(std::isnan(value_named(unknown, "sn-gn").sd));
}

TEST(Anthropometry, RefusesVerticesAndDeviationsThatAreNone) {
    const TriMesh face = somewhere();
    const auto status = [&](std::vector<FacePlace> places, AnthropometryErrors errors) {
        return test::status_of([&] { (void)measure_anthropometry(face, places, errors, {}); });
    };
    EXPECT_EQ(status({{"prn", 9, {}}}, {}), Status::mismatch);
    EXPECT_EQ(status({at("prn", NAN, 0, 0)}, {}), Status::invalid_argument);
    AnthropometryErrors errors;
    errors.place_sd_mm = Vector::Ones(3);
    EXPECT_EQ(status({}, errors), Status::mismatch);
    errors.place_sd_mm = Vector::Constant(9, -1.0);
    EXPECT_EQ(status({}, errors), Status::invalid_argument);
    errors.place_sd_mm.resize(0);
    errors.slide_correlation_mm = -1;
    EXPECT_EQ(status({}, errors), Status::invalid_argument);
}

TEST(Norms, ScoreAgainstThePeopleOfADataset) {
    const TriMesh flat = test::grid(40, 40, 4, 4);
    const std::vector<FacePlace> places{{"ch_right", 0, {}}, {"ch_left", 4, {}}};
    FaceDatasetWriter writer(flat.triangles, flat.vertices.rows(), {"neutral", "smile"});
    for (int person = 0; person < 12; ++person) {
        const double scale = 1 + 0.01 * (person % 2 == 0 ? 1 : -1);
        writer.add(Points(scale * flat.vertices), person, 0);
        writer.add(Points(scale * flat.vertices), person, 0);  // one vote per person
        writer.add(Points(3 * flat.vertices), person, 1);      // not neutral
    }
    const std::string path = testing::TempDir() + "/norms.safetensors";
    writer.save(path, {});
    const NormSet norms = norms_of_dataset(FaceDataset::open(path, {}, {}), places, {});
    const Norm* width = norms.find("ch-ch");
    ASSERT_NE(width, nullptr);
    EXPECT_EQ(width->people, 12);
    EXPECT_NEAR(width->mean, 40.0, 1e-5);
    EXPECT_NEAR(width->sd, 0.4 * std::sqrt(12.0 / 11.0), 1e-5);
    EXPECT_EQ(norms.find("zy-zy"), nullptr);
    TriMesh wide = flat;
    wide.vertices *= 1.05;
    const auto values = measure_anthropometry(wide, places, {}, {});
    const NormScore score = score_against(&norms, value_named(values, "ch-ch"));
    EXPECT_NEAR(score.z, 2.0 / width->sd, 1e-4);
    EXPECT_TRUE(std::isnan(score_against(&norms, value_named(values, "zy-zy")).z));
    const std::string text = norms_json(norms);
    EXPECT_EQ(norms_json(parse_norms(text.data(), text.size(), "norms.json")), text);
}

TEST(Norms, RefuseTooFewPeopleAndFilesThatAreNone) {
    const TriMesh flat = test::grid(40, 40, 4, 4);
    FaceDatasetWriter writer(flat.triangles, flat.vertices.rows(), {"neutral"});
    for (int person = 0; person < 9; ++person) writer.add(flat.vertices, person, 0);
    const std::string path = testing::TempDir() + "/few.safetensors";
    writer.save(path, {});
    EXPECT_EQ(test::status_of([&] {
                  (void)norms_of_dataset(FaceDataset::open(path, {}, {}),
                                         {{"ch_right", 0, {}}, {"ch_left", 4, {}}}, {});
              }),
              Status::invalid_argument);
    const auto parsed = [](const std::string& text) {
        return test::status_of([&] { (void)parse_norms(text.data(), text.size(), "n.json"); });
    };
    EXPECT_EQ(parsed("{}"), Status::bad_format);
    EXPECT_EQ(parsed("{\"norms\":{\"n-gn\":{\"mean\":1,\"sd\":2}}}"), Status::bad_format);
    EXPECT_EQ(parsed("{\"norms\":{\"n-gn\":{\"mean\":1,\"sd\":2,\"people\":3}}}"),
              Status::invalid_argument);
}

}  // namespace
}  // namespace mien
