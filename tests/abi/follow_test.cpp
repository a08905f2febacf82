// Prepared scans, batches and moving faces through the shared library.
#include <limits>

#include "sheets.hpp"

namespace {

using namespace mien_test;

constexpr int kSide = 24;
constexpr double kCell = 6, kHeight = 12, kShape = 0.3;
constexpr int kWidth = 120, kRows = 110;
constexpr double kFocal = 320, kDepth = 400;

SheetArrays moved(double x, double y, double z) {
    SheetArrays sheet = sheet_arrays(kSide, kCell, kHeight, kShape);
    for (std::size_t i = 0; i < sheet.positions.size(); i += 3) {
        sheet.positions[i] += x;
        sheet.positions[i + 1] += y;
        sheet.positions[i + 2] += z;
    }
    return sheet;
}

/// The sheet's own function between its vertices.
double height_at(double x, double y) {
    const double u = x / kCell, v = y / kCell;
    return kHeight * (std::sin(0.3 * u + kShape) * std::cos(0.2 * v - 0.7 * kShape) +
                      0.4 * std::sin(0.11 * u * v / kSide + 2 * kShape));
}

/// A camera with y up and z towards it sees the sheet of moved(x, y, z).
std::vector<double> frame_of(double x, double y, double z) {
    const double size = kCell * (kSide - 1), nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> points;
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kWidth; ++column) {
            const double across = -(column - 0.5 * (kWidth - 1)) / kFocal,
                         up = (row - 0.5 * (kRows - 1)) / kFocal;
            double depth = z;
            for (int step = 0; step < 20; ++step)
                depth = z + height_at(across * depth - x, up * depth - y);
            const double u = across * depth - x, v = up * depth - y;
            if (u < 0 || v < 0 || u > size || v > size)
                points.insert(points.end(), {nan, nan, nan});
            else
                points.insert(points.end(), {across * depth, up * depth, depth});
        }
    return points;
}

mien_array_view view_of(const std::vector<double>& points) {
    return {points.data(), points.size() / 3, 0, MIEN_DTYPE_F64, 0};
}

class Sheet : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        session_ = new Session(2);
        const Mesh mesh = make_mesh(*session_, moved(0, 0, 0));
        mien_model_options options;
        mien_model_options_init(&options, sizeof options);
        options.num_modes = 60;
        options.num_control_points = 100;
        options.sigma_mm = 40;
        const mien_landmark landmarks[] = {{"a", 0, 0},
                                           {"b", kSide - 1, 0},
                                           {"c", kSide * (kSide - 1), 0},
                                           {"d", kSide * kSide / 2 + kSide / 2, 0}};
        options.landmarks = landmarks;
        options.landmark_count = 4;
        ASSERT_EQ(MIEN_OK, mien_model_build(*session_, mesh.get(), &options, &model_, nullptr));
    }
    static void TearDownTestSuite() {
        mien_model_release(model_);
        delete session_;
    }

    /// Options with the places of the landmarks of moved(x, y, z).
    struct Marked {
        explicit Marked(const SheetArrays& truth) {
            mien_register_options_init(&options, sizeof options);
            const int vertices[] = {0, kSide - 1, kSide * (kSide - 1),
                                    kSide * kSide / 2 + kSide / 2};
            const char* names[] = {"a", "b", "c", "d"};
            for (int k = 0; k < 4; ++k) {
                places[k].name = names[k];
                for (int axis = 0; axis < 3; ++axis)
                    places[k].position[axis] =
                        truth.positions[static_cast<std::size_t>(3 * vertices[k] + axis)];
            }
            options.landmarks = places;
            options.landmark_count = 4;
            options.units = MIEN_UNITS_MILLIMETRES;
        }
        Marked(const Marked&) = delete;
        Marked& operator=(const Marked&) = delete;
        mien_scan_landmark places[4] = {};
        mien_register_options options;
    };

    static inline Session* session_ = nullptr;
    static inline mien_model* model_ = nullptr;
};

TEST_F(Sheet, PreparedOnceIsFittedWithTheBitsOfAScanThatIsNot) {
    const SheetArrays truth = moved(3, -2, 20);
    const Marked marked(truth);
    const Mesh scan = make_mesh(*session_, truth);
    mien_registration *alone = nullptr, *again = nullptr;
    ASSERT_EQ(MIEN_OK,
              mien_register(*session_, model_, scan.get(), &marked.options, &alone, nullptr));
    mien_ready_scan* ready = nullptr;
    ASSERT_EQ(MIEN_OK,
              mien_ready_scan_create(*session_, scan.get(), &marked.options, &ready, nullptr));
    mien_ready_scan_retain(ready);
    mien_ready_scan_release(ready);  // one reference is left
    for (int turn = 0; turn < 2; ++turn) {
        ASSERT_EQ(MIEN_OK, mien_ready_scan_register(*session_, model_, ready, &marked.options,
                                                    &again, nullptr));
        EXPECT_EQ(positions_of(mien_registration_mesh(alone)),
                  positions_of(mien_registration_mesh(again)));
        mien_registration_release(again);
    }
    mien_ready_scan_release(ready);
    mien_registration_release(alone);
}

TEST_F(Sheet, ABatchFitsEachScanAsAloneAndTellsWhichOnesItCannot) {
    mien_batch* batch = nullptr;
    ASSERT_EQ(MIEN_OK, mien_batch_create(*session_, model_, &batch, nullptr));
    const SheetArrays first = moved(3, -2, 20), second = moved(0, 5, -10);
    const Mesh scans[] = {make_mesh(*session_, first), make_mesh(*session_, second)};
    const Marked marked[] = {Marked(first), Marked(second)};
    mien_register_options impossible = marked[0].options;
    impossible.landmark_count = 2;
    impossible.start = MIEN_START_LANDMARKS;
    for (int k = 0; k < 2; ++k)
        ASSERT_EQ(MIEN_OK,
                  mien_batch_add(*session_, batch, scans[k].get(), &marked[k].options, nullptr));
    ASSERT_EQ(MIEN_OK, mien_batch_add(*session_, batch, scans[0].get(), &impossible, nullptr));
    mien_batch_retain(batch);
    mien_batch_release(batch);  // one reference is left
    mien_registration* fit = nullptr;
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_batch_get_registration(batch, 0, &fit, nullptr));
    ASSERT_EQ(MIEN_OK, mien_batch_run(*session_, batch, nullptr, nullptr));
    std::uint32_t added = 0, run = 0;
    EXPECT_EQ(MIEN_OK, mien_batch_get_counts(batch, &added, &run, nullptr));
    EXPECT_EQ(added, 3u);
    EXPECT_EQ(run, 3u);
    for (int k = 0; k < 2; ++k) {
        ASSERT_EQ(MIEN_OK, mien_batch_get_registration(batch, k, &fit, nullptr));
        mien_registration* alone = nullptr;
        ASSERT_EQ(MIEN_OK, mien_register(*session_, model_, scans[k].get(), &marked[k].options,
                                         &alone, nullptr));
        EXPECT_EQ(positions_of(mien_registration_mesh(alone)),
                  positions_of(mien_registration_mesh(fit)));
        mien_registration_release(alone);
        mien_registration_release(fit);
    }
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_batch_get_registration(batch, 2, &fit, &error));
    EXPECT_NE(nullptr, std::strstr(error.message, "at least 3")) << error.message;
    EXPECT_EQ(nullptr, fit);
    mien_batch_release(batch);
}

TEST_F(Sheet, ACancelledBatchFitsNothingAndCanBeRunAgain) {
    mien_batch* batch = nullptr;
    ASSERT_EQ(MIEN_OK, mien_batch_create(*session_, model_, &batch, nullptr));
    const SheetArrays truth = moved(1, 1, 1);
    const Marked marked(truth);
    ASSERT_EQ(MIEN_OK, mien_batch_add(*session_, batch, make_mesh(*session_, truth).get(),
                                      &marked.options, nullptr));
    mien_cancel* cancel = nullptr;
    ASSERT_EQ(MIEN_OK, mien_cancel_create(&cancel, nullptr));
    mien_cancel_request(cancel);
    mien_batch_options options;
    mien_batch_options_init(&options, sizeof options);
    options.cancel = cancel;
    EXPECT_EQ(MIEN_E_CANCELLED, mien_batch_run(*session_, batch, &options, nullptr));
    std::uint32_t run = 7;
    mien_batch_get_counts(batch, nullptr, &run, nullptr);
    EXPECT_EQ(run, 0u);
    options.cancel = nullptr;
    EXPECT_EQ(MIEN_OK, mien_batch_run(*session_, batch, &options, nullptr));
    mien_batch_get_counts(batch, nullptr, &run, nullptr);
    EXPECT_EQ(run, 1u);
    mien_cancel_release(cancel);
    mien_batch_release(batch);
}

TEST_F(Sheet, IsFollowedBeforeACameraAndToldAsLostWhenItIsGone) {
    const Mesh mesh = make_mesh(*session_, moved(-69, -69, -kDepth));
    mien_registration* start = nullptr;
    ASSERT_EQ(MIEN_OK, mien_registration_create(*session_, mesh.get(), nullptr, nullptr, nullptr,
                                                MIEN_QUALITY_GOOD, &start, nullptr));
    mien_follow_options options;
    mien_follow_options_init(&options, sizeof options);
    mien_follower* follower = nullptr;
    ASSERT_EQ(MIEN_OK,
              mien_follower_create(*session_, model_, start, &options, &follower, nullptr));
    mien_registration_release(start);
    mien_follower_retain(follower);
    mien_follower_release(follower);  // one reference is left
    mien_follow_state state{};
    state.struct_size = sizeof state;
    std::vector<double> fitted;
    for (int k = 1; k <= 5; ++k) {
        const double x = -69 + 1.5 * k, z = -kDepth + 2 * k;
        const std::vector<double> points = frame_of(x, -69, z);
        const mien_array_view view = view_of(points);
        ASSERT_EQ(MIEN_OK,
                  mien_follower_fit(*session_, follower, &view, kWidth, kRows, &state, nullptr));
        EXPECT_EQ(state.state, MIEN_FOLLOW_FOLLOWED) << k << ": share " << state.share;
        mien_mesh* out = nullptr;
        ASSERT_EQ(MIEN_OK, mien_follower_get_mesh(follower, &out, nullptr));
        fitted = positions_of(out);
        mien_mesh_release(out);
        EXPECT_LT(mean_distance(fitted, moved(x, -69, z).positions), 1) << k;
        double matrix[16];
        ASSERT_EQ(MIEN_OK, mien_follower_get_motion(follower, matrix, nullptr));
        EXPECT_NEAR(matrix[11], z, 2);
    }
    const std::vector<double> nothing(3 * kWidth * kRows, 0.0);
    const mien_array_view view = view_of(nothing);
    ASSERT_EQ(MIEN_OK,
              mien_follower_fit(*session_, follower, &view, kWidth, kRows, &state, nullptr));
    EXPECT_EQ(state.state, MIEN_FOLLOW_LOST);
    mien_mesh* out = nullptr;
    ASSERT_EQ(MIEN_OK, mien_follower_get_mesh(follower, &out, nullptr));
    EXPECT_EQ(positions_of(out), fitted);
    mien_mesh_release(out);
    EXPECT_EQ(MIEN_E_MISMATCH,
              mien_follower_fit(*session_, follower, &view, kWidth, kRows - 1, &state, nullptr));
    mien_follower_release(follower);
}

TEST_F(Sheet, FollowersRefuseWrongOptionsAndTemplates) {
    const Mesh mesh = make_mesh(*session_, moved(0, 0, 0));
    const Mesh other = make_sheet(*session_, 5);
    mien_registration *start = nullptr, *foreign = nullptr;
    ASSERT_EQ(MIEN_OK, mien_registration_create(*session_, mesh.get(), nullptr, nullptr, nullptr,
                                                MIEN_QUALITY_GOOD, &start, nullptr));
    ASSERT_EQ(MIEN_OK, mien_registration_create(*session_, other.get(), nullptr, nullptr, nullptr,
                                                MIEN_QUALITY_GOOD, &foreign, nullptr));
    mien_follower* follower = nullptr;
    EXPECT_EQ(MIEN_E_MISMATCH,
              mien_follower_create(*session_, model_, foreign, nullptr, &follower, nullptr));
    mien_follow_options options;
    mien_follow_options_init(&options, sizeof options);
    options.lost_share = 1.5;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_follower_create(*session_, model_, start, &options, &follower, nullptr));
    mien_follow_options_init(&options, sizeof options);
    options.focal_x = 300;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_follower_create(*session_, model_, start, &options, &follower, nullptr));
    mien_follow_options_init(&options, sizeof options);
    options.reserved = 1;
    EXPECT_EQ(MIEN_E_UNSUPPORTED_OPTION,
              mien_follower_create(*session_, model_, start, &options, &follower, nullptr));
    EXPECT_EQ(nullptr, follower);
    mien_registration_release(start);
    mien_registration_release(foreign);
}

}  // namespace
