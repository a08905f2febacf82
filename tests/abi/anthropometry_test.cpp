#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "sheets.hpp"

namespace {

using namespace mien_test;

/// A sheet about x = 0, 11 x 9 vertices, 5 mm apart (`cell` across), with a hill of `height` on its
/// left side.
Mesh sheet(mien_session* session, double height, double cell = 5) {
    std::vector<double> positions;
    std::vector<uint32_t> triangles;
    for (int j = 0; j < 9; ++j)
        for (int i = 0; i < 11; ++i) {
            const double x = cell * (i - 5), y = 5.0 * j;
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
    std::ofstream("anthropometry_corners.json")
        << R"({"vertices": {"ch_right": 0, "ch_left": 10, "sn": 49}})";
    mien_landmarks* marks = nullptr;
    EXPECT_EQ(MIEN_OK, mien_landmarks_load(session, "anthropometry_corners.json", &marks, nullptr));
    return marks;
}

TEST(Anthropometry, GivesValuesReasonsAndScores) {
    Session session;
    const Mesh face = sheet(session, 0);
    mien_landmarks* marks = corners(session);
    std::ofstream("anthropometry_norms.json")
        << R"({"norms": {"ch-ch": {"mean": 45, "sd": 2, "people": 30}}})";
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

/// The text of one measurement in the JSON of all.
std::string part_of(const std::string& json, const std::string& name) {
    const std::size_t at = json.find("\"name\":\"" + name + "\"");
    EXPECT_NE(std::string::npos, at) << name;
    return at == std::string::npos ? std::string() : json.substr(at, json.find("}", at) - at);
}

/// Twelve people of known breadth; the odd ones were measured twice, the last one smiles only.
std::string breadths(mien_session* session, double& mean, double& sd) {
    constexpr int kPeople = 12;
    const Mesh topology = sheet(session, 0);
    const char* names[] = {"neutral", "smile"};
    mien_dataset_writer* writer = nullptr;
    EXPECT_EQ(MIEN_OK,
              mien_dataset_writer_create(session, topology.get(), names, 2, &writer, nullptr));
    mean = sd = 0;
    std::vector<double> all;
    for (int person = 0; person <= kPeople; ++person) {
        const double cell = 5 + 0.05 * ((person * 7) % kPeople);
        const std::vector<double> face = positions_of(sheet(session, 0, cell).get());
        const mien_array_view view = {face.data(), face.size() / 3, 0, MIEN_DTYPE_F64, 0};
        const int expression = person == kPeople ? 1 : 0;
        for (int repeat = 0; repeat <= person % 2; ++repeat)
            EXPECT_EQ(MIEN_OK, mien_dataset_writer_add(writer, &view, person, expression, nullptr));
        if (expression == 0) all.push_back(10 * cell);
    }
    for (const double value : all) mean += value / kPeople;
    for (const double value : all) sd += (value - mean) * (value - mean) / (kPeople - 1);
    sd = std::sqrt(sd);
    const std::string path = temporary_path("breadths.safetensors");
    EXPECT_EQ(MIEN_OK, mien_dataset_writer_save(session, writer, path.c_str(), nullptr));
    mien_dataset_writer_release(writer);
    return path;
}

TEST(Norms, OfADatasetAreMeanAndDeviationOverItsPeople) {
    Session session;
    mien_landmarks* marks = corners(session);
    double mean = 0, sd = 0;
    const std::string data = breadths(session, mean, sd);
    mien_norms *norms = nullptr, *read = nullptr;
    mien_error error = fresh_error();
    ASSERT_EQ(MIEN_OK, mien_norms_create(session, data.c_str(), marks, nullptr, &norms, &error))
        << error.message;
    const auto json_of = [](const mien_norms* of) {
        return text_of([of](char* dst, std::uint64_t capacity, std::uint64_t* count) {
            return mien_norms_get_json(of, dst, capacity, count, nullptr);
        });
    };
    const std::string json = json_of(norms);
    const std::string one = json.substr(json.find("\"ch-ch\""));
    EXPECT_NEAR(mean, json_number(one, "mean"), 1e-4) << json;
    EXPECT_NEAR(sd, json_number(one, "sd"), 1e-4);
    EXPECT_EQ(12, json_number(one, "people"));
    const std::string path = temporary_path("norms.json");
    ASSERT_EQ(MIEN_OK, mien_norms_save(session, norms, path.c_str(), nullptr));
    ASSERT_EQ(MIEN_OK, mien_norms_load(session, path.c_str(), &read, nullptr));
    EXPECT_EQ(json, json_of(read));
    // A face of 60 mm against them.
    mien_anthropometry_options options;
    mien_anthropometry_options_init(&options, sizeof options);
    options.norms = read;
    mien_anthropometry* list = nullptr;
    const Mesh broad = sheet(session, 0, 6);
    ASSERT_EQ(MIEN_OK,
              mien_measure_anthropometry(session, broad.get(), marks, &options, &list, nullptr));
    const std::string measured =
        text_of([list](char* dst, std::uint64_t capacity, std::uint64_t* count) {
            return mien_anthropometry_get_json(list, dst, capacity, count, nullptr);
        });
    EXPECT_NEAR(60, json_number(part_of(measured, "ch-ch"), "value"), 1e-9) << measured;
    EXPECT_NEAR((60 - mean) / sd, json_number(part_of(measured, "ch-ch"), "z"), 1e-3);
    EXPECT_NE(std::string::npos, part_of(measured, "sn-prn").find("\"reason\"")) << measured;
    EXPECT_NE(std::string::npos, measured.find("\"cheilion_left\":\"ch_left\"")) << measured;
    mien_anthropometry_release(list);
    mien_norms_release(read);
    mien_norms_release(norms);
    mien_landmarks_release(marks);
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
