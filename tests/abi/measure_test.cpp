#include <limits>

#include "handles.hpp"

namespace {

using namespace mien_test;

Mesh raised_square(mien_session* session, float height) {
    Square square;
    for (int v = 0; v < 4; ++v) square.positions[3 * v + 2] = height;
    const mien_mesh_arrays arrays = square.arrays();
    mien_mesh* mesh = nullptr;
    EXPECT_EQ(MIEN_OK, mien_mesh_create(session, &arrays, &mesh, nullptr));
    return Mesh(mesh, mien_mesh_release);
}

mien_zone_volume fresh_volume() {
    mien_zone_volume volume{};
    volume.struct_size = sizeof volume;
    return volume;
}

TEST(Measure, VolumeOfARaisedSquareAndItsZone) {
    Session session;
    const Mesh before = raised_square(session, 0), after = raised_square(session, 2);
    const uint32_t corner[] = {1};
    const mien_zone zone{"corner", corner, 1};
    const double sd[] = {0.1, 0.1, 0.1, 0.1};
    mien_measure_options options;
    mien_measure_options_init(&options, sizeof options);
    options.zones = &zone;
    options.zone_count = 1;
    options.after_sd = {sd, 4, 0, MIEN_DTYPE_F64, 0};
    options.correlation_length_mm = 1e6;
    options.limit_of_detection_ml = 1.0;
    mien_measurement* m = nullptr;
    ASSERT_EQ(MIEN_OK,
              mien_measure_volume(session, before.get(), after.get(), &options, &m, nullptr));
    mien_zone_volume whole = fresh_volume(), part = fresh_volume(), rest = fresh_volume();
    EXPECT_EQ(MIEN_OK, mien_measurement_get_volume(m, MIEN_ZONE_WHOLE, &whole, nullptr));
    EXPECT_EQ(MIEN_OK, mien_measurement_get_volume(m, 0, &part, nullptr));
    EXPECT_EQ(MIEN_OK, mien_measurement_get_volume(m, MIEN_ZONE_REST, &rest, nullptr));
    EXPECT_NEAR(2e-3, whole.signed_ml, 1e-15);
    EXPECT_NEAR(2e-3 / 6, part.signed_ml, 1e-15);
    EXPECT_NEAR(whole.signed_ml, part.signed_ml + rest.signed_ml, 1e-15);
    EXPECT_NEAR(1e-4, whole.sd_ml, 1e-9);
    EXPECT_EQ(0, whole.detected);
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_measurement_get_volume(m, 1, &part, nullptr));
    uint64_t size = 0;
    EXPECT_EQ(MIEN_OK, mien_measurement_get_json(m, nullptr, 0, &size, nullptr));
    std::string json(size, 'x');
    EXPECT_EQ(MIEN_OK, mien_measurement_get_json(m, &json[0], size, nullptr, nullptr));
    EXPECT_NE(std::string::npos, json.find("\"below_limit_of_detection\":true"));
    double share[4];
    EXPECT_EQ(MIEN_OK, mien_measurement_get_field(m, MIEN_FIELD_POSITIVE_VOLUME_MM3, share, 4,
                                                  nullptr, nullptr));
    EXPECT_NEAR(2.0, share[0] + share[1] + share[2] + share[3], 1e-12);
    EXPECT_EQ(MIEN_E_NOT_FOUND,
              mien_measurement_get_field(m, MIEN_FIELD_DISTANCE_MM, share, 4, nullptr, nullptr));
    mien_measurement_release(m);
    mien_measurement_release(nullptr);
}

TEST(Measure, DistanceAndAreaOfASquare) {
    Session session;
    const Mesh before = raised_square(session, 0), after = raised_square(session, -3);
    mien_measurement* m = nullptr;
    ASSERT_EQ(MIEN_OK,
              mien_measure_distance(session, before.get(), after.get(), nullptr, &m, nullptr));
    mien_zone_distance d{};
    d.struct_size = sizeof d;
    EXPECT_EQ(MIEN_OK, mien_measurement_get_distance(m, MIEN_ZONE_WHOLE, &d, nullptr));
    EXPECT_NEAR(-3, d.mean_signed_mm, 1e-6);
    EXPECT_NEAR(3, d.max_length_mm, 1e-6);
    EXPECT_EQ(4u, d.vertex_count);
    mien_measurement_release(m);
    double area = 0, volume = 0;
    EXPECT_EQ(MIEN_OK, mien_measure_area(session, before.get(), nullptr, &area, nullptr));
    EXPECT_NEAR(1, area, 1e-12);
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_INVALID_MESH,
              mien_measure_closed_volume(session, before.get(), 0, &volume, &error));
    EXPECT_NE(nullptr, std::strstr(error.message, "4 open edges"));
    EXPECT_EQ(MIEN_OK, mien_measure_closed_volume(session, before.get(), 1, &volume, nullptr));
    EXPECT_NEAR(0, volume, 1e-15);
}

TEST(Measure, RefusesWrongInputAndStaysUsable) {
    Session session;
    const Mesh mesh = make_square(session);
    mien_measurement* m = nullptr;
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_INVALID_HANDLE,
              mien_measure_volume(session, nullptr, mesh.get(), nullptr, &m, &error));
    EXPECT_EQ(MIEN_E_INVALID_HANDLE,
              mien_measure_volume(nullptr, mesh.get(), mesh.get(), nullptr, &m, &error));
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_measure_volume(session, mesh.get(), mesh.get(), nullptr, nullptr, &error));
    mien_measure_options options;
    mien_measure_options_init(&options, sizeof options);
    const uint32_t outside[] = {4};
    const mien_zone zone{"far", outside, 1};
    options.zones = &zone;
    options.zone_count = 1;
    EXPECT_EQ(MIEN_E_MISMATCH,
              mien_measure_volume(session, mesh.get(), mesh.get(), &options, &m, &error));
    EXPECT_EQ(4, error.detail_index);
    EXPECT_NE(nullptr, std::strstr(error.message, "far"));
    options.zone_count = 0;
    options.correlation_length_mm = std::numeric_limits<double>::quiet_NaN();
    options.common_bias_mm = 1;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_measure_volume(session, mesh.get(), mesh.get(), &options, &m, &error));
    EXPECT_EQ(nullptr, m);
    mien_measure_options_init(&options, sizeof options);
    mien_cancel* cancel = nullptr;
    ASSERT_EQ(MIEN_OK, mien_cancel_create(&cancel, nullptr));
    mien_cancel_request(cancel);
    options.cancel = cancel;
    EXPECT_EQ(MIEN_E_CANCELLED,
              mien_measure_volume(session, mesh.get(), mesh.get(), &options, &m, &error));
    mien_cancel_release(cancel);
    EXPECT_EQ(MIEN_OK, mien_measure_volume(session, mesh.get(), mesh.get(), nullptr, &m, &error));
    mien_zone_volume short_struct{};
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_measurement_get_volume(m, MIEN_ZONE_WHOLE, &short_struct, &error));
    mien_measurement_release(m);
}

// A count that no zone of the surface can have would be followed off the end of the host's array.
TEST(AbiMeasure, AZoneLongerThanItsSurfaceIsRefusedUnread) {
    Session session;
    const Mesh mesh = make_square(session);
    const uint32_t corner[] = {0};
    const mien_zone zone{"endless", corner, 0x7fffffff};
    mien_error error = fresh_error();
    double area = 0;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_measure_area(session, mesh.get(), &zone, &area, &error));
    EXPECT_NE(nullptr, std::strstr(error.message, "endless"));
    uint32_t inside[4];
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_surface_transfer_zone(session, mesh.get(), corner, 0x7fffffff, mesh.get(), 0,
                                         inside, 4, nullptr, nullptr));
    mien_model* model = nullptr;
    mien_model_options options;
    mien_model_options_init(&options, sizeof options);
    options.zones = &zone;
    options.zone_count = 1;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_model_build(session, mesh.get(), &options, &model, nullptr));
}

TEST(Measure, LengthsAndCurvatureOfASquare) {
    Session session;
    const Mesh square = raised_square(session, 0);
    const uint32_t pairs[] = {0, 2, 1, 1};
    double straight[2] = {}, geodesic[2] = {};
    ASSERT_EQ(MIEN_OK,
              mien_measure_lengths(session, square.get(), pairs, 2, straight, geodesic, nullptr));
    EXPECT_NEAR(std::sqrt(2.0), straight[0], 1e-6);
    EXPECT_GE(geodesic[0], straight[0]);
    EXPECT_EQ(0, geodesic[1]);
    EXPECT_EQ(MIEN_OK,
              mien_measure_lengths(session, square.get(), pairs, 2, nullptr, nullptr, nullptr));
    const uint32_t unknown[] = {0, 99};
    EXPECT_EQ(MIEN_E_MISMATCH,
              mien_measure_lengths(session, square.get(), unknown, 1, straight, nullptr, nullptr));
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_measure_lengths(session, square.get(), pairs, 0, straight, nullptr, nullptr));

    mien_measurement* m = nullptr;
    ASSERT_EQ(MIEN_OK, mien_measure_curvature(session, square.get(), 3, 1, nullptr, &m, nullptr));
    double values[4] = {1, 1, 1, 1};
    EXPECT_EQ(MIEN_OK, mien_measurement_get_field(m, MIEN_FIELD_CURVATURE_MEAN, values, 4, nullptr,
                                                  nullptr));
    for (double value : values) EXPECT_NEAR(0, value, 1e-6);
    EXPECT_EQ(MIEN_E_NOT_FOUND,
              mien_measurement_get_field(m, MIEN_FIELD_DISTANCE_MM, values, 4, nullptr, nullptr));
    mien_measurement_release(m);
    m = nullptr;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_measure_curvature(session, square.get(), 0, 1, nullptr, &m, nullptr));
    EXPECT_EQ(MIEN_E_UNSUPPORTED_OPTION,
              mien_measure_curvature(session, square.get(), 3, 2, nullptr, &m, nullptr));
    EXPECT_EQ(nullptr, m);
}

}  // namespace
