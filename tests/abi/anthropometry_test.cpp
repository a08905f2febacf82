#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "handles.hpp"

namespace {

using namespace mien_test;

/// A sheet about x = 0, 11 x 9 vertices, 5 mm apart, with a hill of `height` on its left side.
Mesh sheet(mien_session* session, double height) {
    std::vector<double> positions;
    std::vector<uint32_t> triangles;
    for (int j = 0; j < 9; ++j)
        for (int i = 0; i < 11; ++i) {
            const double x = 5.0 * (i - 5), y = 5.0 * j;
            const double d2 = (x - 12) * (x - 12) + (y - 20) * (y - 20);
            positions.insert(positions.end(), {x, y, 0.01 * x * x + height * std::exp(-d2 / 50)});
        }
    for (uint32_t j = 0; j < 8; ++j)
        for (uint32_t i = 0; i < 10; ++i) {
            const uint32_t a = 11 * j + i, c = a + 11;
            triangles.insert(triangles.end(), {a, a + 1, c + 1, a, c + 1, c});
        }
    mien_mesh_arrays arrays;
    mien_mesh_arrays_init(&arrays, sizeof arrays);
    arrays.positions = {positions.data(), positions.size() / 3, 0, MIEN_DTYPE_F64, 0};
    arrays.triangles = triangles.data();
    arrays.triangle_count = triangles.size() / 3;
    mien_mesh* mesh = nullptr;
    EXPECT_EQ(MIEN_OK, mien_mesh_create(session, &arrays, &mesh, nullptr));
    return Mesh(mesh, mien_mesh_release);
}

mien_landmarks* corners(mien_session* session) {
    std::ofstream("anthropometry_corners.json") << R"({"vertices": {"ch_right": 0, "ch_left": 10, "sn": 49}})";
    mien_landmarks* marks = nullptr;
    EXPECT_EQ(MIEN_OK, mien_landmarks_load(session, "anthropometry_corners.json", &marks, nullptr));
    return marks;
}

TEST(Anthropometry, GivesValuesReasonsAndScores) {
    Session session;
    const Mesh face = sheet(session, 0);
    mien_landmarks* marks = corners(session);
    std::ofstream("anthropometry_norms.json") << R"({"norms": {"ch-ch": {"mean": 45, "sd": 2, "people": 30}}})";
    mien_norms* norms = nullptr;
    ASSERT_EQ(MIEN_OK, mien_norms_load(session, "anthropometry_norms.json", &norms, nullptr));
    const std::vector<double> sd(99, 0.3);
    mien_anthropometry_options options;
    mien_anthropometry_options_init(&options, sizeof options);
    options.place_sd = {sd.data(), sd.size(), 0, MIEN_DTYPE_F64, 0};
    options.slide_correlation_mm = 0;
    options.normal_correlation_mm = 0;
    options.norms = norms;
    mien_anthropometry* list = nullptr;
    ASSERT_EQ(MIEN_OK,
              mien_measure_anthropometry(session, face.get(), marks, &options, &list, nullptr));
    uint64_t count = 0, known = 0;
    EXPECT_EQ(MIEN_OK, mien_anthropometry_get_counts(list, &count, &known, nullptr));
    EXPECT_GE(count, 40u);
    EXPECT_EQ(1u, known);
    bool found = false, lacking = false;
    for (uint64_t k = 0; k < count; ++k) {
        char name[64], reason[256];
        ASSERT_EQ(MIEN_OK, mien_anthropometry_get_name(list, k, name, 64, nullptr, nullptr));
        ASSERT_EQ(MIEN_OK, mien_anthropometry_get_reason(list, k, reason, 256, nullptr, nullptr));
        mien_anthropometric_value value{};
        value.struct_size = sizeof value;
        ASSERT_EQ(MIEN_OK, mien_anthropometry_get_value(list, k, &value, nullptr));
        EXPECT_EQ(std::isnan(value.value), reason[0] != 0) << name;
        if (std::string(name) == "ch-ch") {
            found = true;
            EXPECT_EQ(MIEN_MEASURE_LENGTH, value.kind);
            EXPECT_NEAR(50.0, value.value, 1e-9);
            EXPECT_NEAR(0.3 * std::sqrt(2.0), value.sd, 1e-6);
            EXPECT_NEAR(2.5, value.z, 1e-9);
            EXPECT_EQ(30u, value.norm_people);
        }
        if (std::string(name) == "sn-prn") {
            lacking = true;
            EXPECT_NE(std::string::npos, std::string(reason).find("pronasale"));
        }
    }
    EXPECT_TRUE(found && lacking);
    mien_anthropometric_value value{};
    value.struct_size = sizeof value;
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_anthropometry_get_value(list, count, &value, nullptr));
    mien_norms_release(norms);
    mien_landmarks_release(marks);
    mien_anthropometry_release(list);  // holds nothing of the norms
}

TEST(Asymmetry, OfAHillOnTheLeftIsPositiveAndHasItsPlane) {
    Session session;
    const Mesh face = sheet(session, 2), flat = sheet(session, 0);
    mien_measurement* m = nullptr;
    ASSERT_EQ(MIEN_OK,
              mien_measure_asymmetry(session, face.get(), flat.get(), nullptr, &m, nullptr));
    mien_zone_volume whole{};
    whole.struct_size = sizeof whole;
    EXPECT_EQ(MIEN_OK, mien_measurement_get_volume(m, MIEN_ZONE_WHOLE, &whole, nullptr));
    EXPECT_NEAR(2 * 3.14159 * 50 / 1000, whole.signed_ml, 0.03);
    mien_mirror_plane plane{};
    plane.struct_size = sizeof plane;
    EXPECT_EQ(MIEN_OK, mien_measurement_get_mirror_plane(m, &plane, nullptr));
    EXPECT_EQ(MIEN_MIRROR_BY_SURFACE, plane.by);
    EXPECT_GT(plane.normal[0], 0.99);
    EXPECT_TRUE(std::isnan(plane.between_rad));
    mien_measurement_release(m);
    // Found by landmarks that are not there, and about a template without symmetry.
    mien_asymmetry_options options;
    mien_asymmetry_options_init(&options, sizeof options);
    options.plane = MIEN_MIRROR_BY_LANDMARKS;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_measure_asymmetry(session, face.get(), flat.get(), &options, &m, nullptr));
    options.plane = 7;
    EXPECT_EQ(MIEN_E_UNSUPPORTED_OPTION,
              mien_measure_asymmetry(session, face.get(), flat.get(), &options, &m, nullptr));
    const double shift[16] = {1, 0, 0, 40, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    mien_mesh* aside = nullptr;
    ASSERT_EQ(MIEN_OK, mien_mesh_transform(session, flat.get(), shift, &aside, nullptr));
    EXPECT_EQ(MIEN_E_INVALID_MESH,
              mien_measure_asymmetry(session, face.get(), aside, nullptr, &m, nullptr));
    mien_mesh_release(aside);
    // Another measurement has no plane.
    ASSERT_EQ(MIEN_OK, mien_measure_volume(session, flat.get(), face.get(), nullptr, &m, nullptr));
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_measurement_get_mirror_plane(m, &plane, nullptr));
    mien_measurement_release(m);
}

}  // namespace
