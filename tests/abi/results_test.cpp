// Results, not only statuses, of what other tests do not call: registration, transfer, alignment,
// scan volume.
#include <cstdlib>
#include <limits>

#include "sheets.hpp"

namespace {

using namespace mien_test;

constexpr int kSide = 24;
constexpr double kCell = 6;

/// Turned about z by `angle` and moved.
SheetArrays moved(SheetArrays sheet, double angle, double x, double y, double z) {
    const double c = std::cos(angle), s = std::sin(angle);
    for (std::size_t i = 0; i < sheet.positions.size(); i += 3) {
        const double px = sheet.positions[i], py = sheet.positions[i + 1];
        sheet.positions[i] = c * px - s * py + x;
        sheet.positions[i + 1] = s * px + c * py + y;
        sheet.positions[i + 2] += z;
    }
    return sheet;
}

SheetArrays face_like() {
    return sheet_arrays(kSide, kCell, 12, 0.3);
}

class Fitted : public testing::Test {
  protected:
    static constexpr double kAngle = 0.05, kMove[3] = {4, -3, 30};

    static void SetUpTestSuite() {
        session_ = new Session(2);
        const Mesh mesh = make_mesh(*session_, face_like());
        mien_model_options options;
        mien_model_options_init(&options, sizeof options);
        options.num_modes = 90;
        options.num_control_points = 150;
        options.sigma_mm = 40;
        const std::uint32_t corner[] = {0, 1, kSide, kSide + 1};
        const mien_zone zone = {"corner", corner, 4};
        const mien_landmark landmarks[] = {
            {"low_left", 0, 0},
            {"low_right", kSide - 1, 0},
            {"high_left", kSide * (kSide - 1), 0},
            {"high_right", kSide * kSide - 1, 0},
            {"middle", kSide * kSide / 2 + kSide / 2, 0},
        };
        options.landmarks = landmarks;
        options.landmark_count = 5;
        options.zones = &zone;
        options.zone_count = 1;
        ASSERT_EQ(MIEN_OK, mien_model_build(*session_, mesh.get(), &options, &model_, nullptr));
        truth_ = moved(face_like(), kAngle, kMove[0], kMove[1], kMove[2]);
        const Mesh scan = make_mesh(*session_, truth_);
        mien_register_options fit;
        mien_register_options_init(&fit, sizeof fit);
        std::vector<mien_scan_landmark> places;
        for (const mien_landmark& l : landmarks) {
            mien_scan_landmark place = {l.name, {}};
            for (int k = 0; k < 3; ++k) place.position[k] = truth_.positions[3 * l.vertex + k];
            places.push_back(place);
        }
        fit.landmarks = places.data();
        fit.landmark_count = places.size();
        fit.units = MIEN_UNITS_MILLIMETRES;
        mien_error error = fresh_error();
        ASSERT_EQ(MIEN_OK, mien_register(*session_, model_, scan.get(), &fit, &fit_, &error))
            << error.message;
    }
    static void TearDownTestSuite() {
        mien_registration_release(fit_);
        mien_model_release(model_);
        delete session_;
    }
    static inline Session* session_ = nullptr;
    static inline mien_model* model_ = nullptr;
    static inline mien_registration* fit_ = nullptr;
    static inline SheetArrays truth_;
};

TEST_F(Fitted, TheTemplateLiesOnTheScan) {
    const std::vector<double> fitted = positions_of(mien_registration_mesh(fit_));
    EXPECT_LT(mean_distance(fitted, truth_.positions), 1.0);
    mien_fit_verdict verdict = {};
    verdict.struct_size = sizeof verdict;
    ASSERT_EQ(MIEN_OK, mien_registration_get_verdict(fit_, &verdict, nullptr));
    EXPECT_LT(verdict.mean_residual_mm, 0.5);
    EXPECT_GT(verdict.coverage, 0.8);
    EXPECT_EQ(5, verdict.landmarks_used + verdict.landmarks_rejected);
    EXPECT_NEAR(1, verdict.size_ratio, 0.1);
    EXPECT_EQ(1, verdict.unit_to_mm);
}

TEST_F(Fitted, ErrorsAreExpectedOfTheFaceAndOfItsZones) {
    mien_fit_verdict verdict = {};
    verdict.struct_size = sizeof verdict;
    ASSERT_EQ(MIEN_OK, mien_registration_get_verdict(fit_, &verdict, nullptr));
    mien_expected_error whole = {}, zone = {};
    whole.struct_size = zone.struct_size = sizeof whole;
    ASSERT_EQ(MIEN_OK, mien_registration_get_expected_error(fit_, nullptr, &whole, nullptr));
    ASSERT_EQ(MIEN_OK, mien_registration_get_expected_error(fit_, "corner", &zone, nullptr));
    for (const mien_expected_error& one : {whole, zone}) {
        EXPECT_GT(one.low_mm, 0);
        EXPECT_LT(one.low_mm, one.expected_mm);
        EXPECT_LT(one.expected_mm, one.high_mm);
        EXPECT_GE(one.unseen, 0);
        EXPECT_LE(one.unseen, 1);
        EXPECT_GE(one.quality, MIEN_QUALITY_GOOD);
        EXPECT_LE(one.quality, MIEN_QUALITY_FAILED);
    }
    // The verdict is no better than what is expected of the whole face.
    EXPECT_GE(verdict.quality, whole.quality);
    const std::string json = text_of([](char* dst, std::uint64_t capacity, std::uint64_t* count) {
        return mien_registration_get_json(fit_, dst, capacity, count, nullptr);
    });
    EXPECT_NE(std::string::npos, json.find("\"expected_error\""));
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_registration_get_expected_error(fit_, "tail", &whole, &error));
    EXPECT_NE(nullptr, std::strstr(error.message, "tail")) << error.message;
}

TEST_F(Fitted, FieldsAndCorrespondenceSpeakOfTheSameFit) {
    const std::uint64_t n = kSide * kSide;
    std::vector<double> residual(n), weight(n), sd(n), radius(n), barycentric(3 * n);
    std::vector<std::uint32_t> triangles(n);
    std::uint64_t count = 0;
    ASSERT_EQ(MIEN_OK, mien_registration_get_field(fit_, MIEN_REGISTRATION_RESIDUAL_MM,
                                                   residual.data(), n, &count, nullptr));
    EXPECT_EQ(n, count);
    ASSERT_EQ(MIEN_OK, mien_registration_get_field(fit_, MIEN_REGISTRATION_WEIGHT, weight.data(), n,
                                                   nullptr, nullptr));
    ASSERT_EQ(MIEN_OK, mien_registration_get_field(fit_, MIEN_REGISTRATION_STANDARD_DEVIATION_MM,
                                                   sd.data(), n, nullptr, nullptr));
    ASSERT_EQ(MIEN_OK, mien_registration_get_field(fit_, MIEN_REGISTRATION_RADIUS95_MM,
                                                   radius.data(), n, nullptr, nullptr));
    ASSERT_EQ(MIEN_OK, mien_registration_get_correspondence(
                           fit_, triangles.data(), barycentric.data(), n, &count, nullptr));
    const std::vector<double> fitted = positions_of(mien_registration_mesh(fit_));
    for (std::uint64_t v = 0; v < n; ++v) {
        EXPECT_GE(weight[v], 0);
        EXPECT_LE(weight[v], 1);
        EXPECT_GT(sd[v], 0);
        EXPECT_GE(radius[v], sd[v]);
        ASSERT_LT(triangles[v], truth_.triangles.size() / 3);
        EXPECT_NEAR(1, barycentric[3 * v] + barycentric[3 * v + 1] + barycentric[3 * v + 2], 1e-9);
        // The place on the scan is as far from the vertex as the residual tells.
        double squared = 0;
        for (int k = 0; k < 3; ++k) {
            double place = 0;
            for (int c = 0; c < 3; ++c)
                place += barycentric[3 * v + c] *
                         truth_.positions[3 * truth_.triangles[3 * triangles[v] + c] + k];
            squared += std::pow(fitted[3 * v + k] - place, 2);
        }
        // The hits are kept in single precision.
        EXPECT_LE(std::abs(residual[v]), std::sqrt(squared) + 2e-5);
    }
}

TEST_F(Fitted, TheMotionAndTheReportAreThoseOfTheScan) {
    double matrix[16];
    ASSERT_EQ(MIEN_OK, mien_registration_get_motion(fit_, matrix, nullptr));
    EXPECT_NEAR(std::atan2(matrix[4], matrix[0]), kAngle, 0.02);
    EXPECT_EQ(1, matrix[15]);
    const std::string json = text_of([](char* dst, std::uint64_t capacity, std::uint64_t* count) {
        return mien_registration_get_json(fit_, dst, capacity, count, nullptr);
    });
    EXPECT_NE(std::string::npos, json.find("\"quality\""));
    EXPECT_NE(std::string::npos, json.find("\"motion\""));
}

TEST_F(Fitted, AReferenceKeepsARegistration) {
    mien_registration_retain(fit_);
    mien_registration_release(fit_);
    EXPECT_NE(nullptr, mien_registration_mesh(fit_));
    mien_registration_retain(nullptr);
    EXPECT_EQ(nullptr, mien_registration_mesh(nullptr));
}

TEST_F(Fitted, PlacesZonesAndLandmarksAreCarriedToTheScan) {
    const Mesh scan = make_mesh(*session_, truth_);
    const mien_mesh* fitted = mien_registration_mesh(fit_);
    const std::vector<double> places = {truth_.positions[30], truth_.positions[31],
                                        truth_.positions[32] + 2};
    const mien_array_view view = {places.data(), 1, 0, MIEN_DTYPE_F64, 0};
    std::uint32_t triangle = 0;
    double barycentric[3], position[3];
    std::uint64_t count = 0;
    ASSERT_EQ(MIEN_OK, mien_surface_transfer_points(*session_, scan.get(), &view, 0, &triangle,
                                                    barycentric, position, 1, &count, nullptr));
    EXPECT_EQ(1u, count);
    EXPECT_LT(std::hypot(position[0] - places[0], position[1] - places[1], position[2] - places[2]),
              2 + 1e-9);
    EXPECT_EQ(MIEN_OK, mien_surface_transfer_points(*session_, scan.get(), &view, 0.1, &triangle,
                                                    nullptr, nullptr, 1, nullptr, nullptr));
    EXPECT_EQ(0xFFFFFFFFu, triangle);

    const std::string landmarks = text_of([&](char* dst, std::uint64_t capacity,
                                              std::uint64_t* size) {
        return mien_surface_transfer_json(*session_, model_, fitted, scan.get(),
                                          MIEN_TRANSFER_LANDMARKS, 0, dst, capacity, size, nullptr);
    });
    EXPECT_NE(std::string::npos, landmarks.find("\"middle\":["));
    EXPECT_LT(json_number(landmarks.substr(landmarks.find("distances_mm")), "middle"), 1.5);
    const std::string zones = text_of([&](char* dst, std::uint64_t capacity, std::uint64_t* size) {
        return mien_surface_transfer_json(*session_, model_, fitted, scan.get(),
                                          MIEN_TRANSFER_ZONES, 0, dst, capacity, size, nullptr);
    });
    EXPECT_NE(std::string::npos, zones.find("\"corner\":[0,1"));
}

TEST(Align, FindsTheMotionBetweenTwoFaces) {
    const Session session;
    const SheetArrays at_home = face_like(), away = moved(at_home, 0.1, 5, 2, -7);
    const Mesh target = make_mesh(session, at_home), moving = make_mesh(session, away);
    mien_zone_alignment info = {};
    info.struct_size = sizeof info;
    mien_mesh* aligned = nullptr;
    ASSERT_EQ(MIEN_OK, mien_measure_align(session, moving.get(), target.get(), nullptr, &info,
                                          &aligned, nullptr));
    EXPECT_LT(mean_distance(positions_of(aligned), at_home.positions), 1e-6);
    EXPECT_LT(info.rms_mm, 1e-6);
    EXPECT_NEAR(std::atan2(info.matrix[4], info.matrix[0]), -0.1, 1e-9);
    EXPECT_GT(info.pairs, 100u);
    mien_mesh_release(aligned);
    const std::uint32_t two[] = {0, 1};
    const mien_zone small = {"two vertices", two, 2};
    EXPECT_EQ(MIEN_E_NO_SOLUTION, mien_measure_align(session, moving.get(), target.get(), &small,
                                                     nullptr, &aligned, nullptr));
    EXPECT_EQ(nullptr, aligned);
}

TEST(ScanVolume, OfALiftedSheetIsAreaTimesHeight) {
    const Session session;
    const SheetArrays flat = sheet_arrays(20, 5, 0);
    // Wider than the other sheet: what lies beyond a border is not seen.
    SheetArrays finer = sheet_arrays(47, 2.5, 0);
    for (std::size_t i = 0; i < finer.positions.size(); i += 3) {
        finer.positions[i] -= 10;
        finer.positions[i + 1] -= 10;
        finer.positions[i + 2] = 2;
    }
    const Mesh before = make_mesh(session, flat), after = make_mesh(session, finer);
    const double up[] = {0, 0, 1};
    mien_measure_options options;
    mien_measure_options_init(&options, sizeof options);
    options.skip_borders = 0;
    for (const std::int32_t carry :
         {MIEN_CARRY_CLOSEST_POINT, MIEN_CARRY_DIRECTION, MIEN_CARRY_VERTEX_NORMAL}) {
        double coverage = 0;
        mien_measurement* m = nullptr;
        mien_error error = fresh_error();
        ASSERT_EQ(MIEN_OK, mien_measure_scan_volume(session, before.get(), after.get(), carry, up,
                                                    &options, &coverage, &m, &error))
            << error.message;
        EXPECT_NEAR(1, coverage, 0.12) << carry;
        mien_zone_volume whole = {};
        whole.struct_size = sizeof whole;
        ASSERT_EQ(MIEN_OK, mien_measurement_get_volume(m, MIEN_ZONE_WHOLE, &whole, nullptr));
        EXPECT_NEAR(coverage * 95 * 95 * 2 / 1000, whole.signed_ml, 0.2) << carry;
        std::uint32_t zones = 9;
        std::int32_t disjoint = 9;
        EXPECT_EQ(MIEN_OK, mien_measurement_get_zones(m, &zones, &disjoint, nullptr));
        EXPECT_EQ(0u, zones);
        EXPECT_EQ(1, disjoint);
        mien_measurement_release(m);
    }
    mien_measurement* m = nullptr;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_measure_scan_volume(session, before.get(), after.get(), MIEN_CARRY_DIRECTION,
                                       nullptr, &options, nullptr, &m, nullptr));
}

TEST(SurfaceDistance, ToALiftedSheetIsTheHeight) {
    const Session session;
    SheetArrays lifted = sheet_arrays(33, 3, 0);
    for (std::size_t i = 2; i < lifted.positions.size(); i += 3) lifted.positions[i] = 1.5;
    const Mesh before = make_mesh(session, sheet_arrays(20, 5, 0)),
               after = make_mesh(session, lifted);
    mien_measurement* m = nullptr;
    ASSERT_EQ(MIEN_OK, mien_measure_surface_distance(session, before.get(), after.get(), nullptr,
                                                     &m, nullptr));
    mien_zone_distance d = {};
    d.struct_size = sizeof d;
    EXPECT_EQ(MIEN_OK, mien_measurement_get_distance(m, MIEN_ZONE_WHOLE, &d, nullptr));
    EXPECT_NEAR(1.5, d.mean_signed_mm, 1e-6);
    EXPECT_NEAR(1.5, d.max_length_mm, 1e-6);
    mien_measurement_release(m);
}

TEST(Version, TheBuildTellsVersionAndCompiler) {
    const std::string id = mien_build_id();
    EXPECT_EQ(0u, id.find("mien " MIEN_VERSION_STRING));
    EXPECT_GT(id.size(), std::string("mien " MIEN_VERSION_STRING).size() + 4);
}

}  // namespace
