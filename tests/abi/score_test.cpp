// Scores and statistics through the shared library: known answers.
#include <cstdlib>
#include <limits>

#include "sheets.hpp"

namespace {

using namespace mien_test;

constexpr int kSide = 14, kFaces = 24;

/// A sheet whose middle sinks with the grade, and whose bumps are the subject's own.
SheetArrays graded_face(int subject, double grade) {
    SheetArrays sheet = sheet_arrays(kSide, 8, 6, 0.1);
    for (int v = 0; v < kSide * kSide; ++v) {
        const double x = v % kSide - 6.5, y = v / kSide - 6.5;
        sheet.positions[3 * v + 2] -= 3 * grade * std::exp(-0.1 * (x * x + y * y));
        sheet.positions[3 * v + 2] += 0.5 * std::sin(1.7 * subject) * std::sin(0.5 * x) +
                                      0.5 * std::cos(2.3 * subject) * y / 7;
    }
    return sheet;
}

class Score : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        session_ = new Session(2);
        path_ = temporary_path("graded.safetensors");
        const Mesh topology = make_mesh(*session_, graded_face(0, 0));
        const char* names[] = {"neutral"};
        mien_dataset_writer* writer = nullptr;
        ASSERT_EQ(MIEN_OK, mien_dataset_writer_create(*session_, topology.get(), names, 1, &writer,
                                                      nullptr));
        std::vector<double> grades;
        for (int k = 0; k < kFaces; ++k) {
            grades.push_back(k % 5);
            const SheetArrays face = graded_face(k, grades.back());
            const mien_array_view view = {face.positions.data(), kSide * kSide, 0, MIEN_DTYPE_F64,
                                          0};
            ASSERT_EQ(MIEN_OK, mien_dataset_writer_add(writer, &view, k, 0, nullptr));
        }
        grades[3] = std::numeric_limits<double>::quiet_NaN();  // not graded
        ASSERT_EQ(MIEN_OK, mien_dataset_writer_save(*session_, writer, path_.c_str(), nullptr));
        mien_dataset_writer_release(writer);
        mien_score_options options;
        mien_score_options_init(&options, sizeof options);
        options.highest = 4;
        options.curvature_radius_mm = 12;
        mien_error error = fresh_error();
        ASSERT_EQ(MIEN_OK, mien_score_model_train(*session_, path_.c_str(), grades.data(), kFaces,
                                                  &options, &model_, &error))
            << error.message;
    }
    static void TearDownTestSuite() {
        mien_score_model_release(model_);
        std::remove(path_.c_str());
        delete session_;
    }
    static mien_score_prediction predict(const mien_score_model* model, const mien_mesh* face) {
        mien_score_prediction p = {};
        p.struct_size = sizeof p;
        EXPECT_EQ(MIEN_OK, mien_score_model_predict(*session_, model, face, &p, nullptr));
        return p;
    }
    static inline Session* session_ = nullptr;
    static inline mien_score_model* model_ = nullptr;
    static inline std::string path_;
};

TEST_F(Score, PredictsTheGradeOfANewFaceWithinItsInterval) {
    for (const double grade : {0.5, 2.0, 3.5}) {
        const Mesh face = make_mesh(*session_, graded_face(77, grade));
        const mien_score_prediction p = predict(model_, face.get());
        EXPECT_NEAR(grade, p.score, 0.5);
        EXPECT_LE(p.low95, p.score);
        EXPECT_GE(p.high95, p.score);
        EXPECT_GT(p.leverage, 0);
    }
}

TEST_F(Score, AnUnlikelyFaceIsSaidToExtrapolate) {
    SheetArrays odd = graded_face(1, 2);
    for (int v = 0; v < kSide * kSide; ++v)
        odd.positions[3 * v + 2] += 40 * std::exp(-0.1 * (v % kSide) * (v / kSide));
    EXPECT_EQ(1, predict(model_, make_mesh(*session_, odd).get()).extrapolates);
}

TEST_F(Score, TheLatentAndTheSimulatedFaceAgree) {
    std::uint64_t count = 0;
    std::vector<double> per_unit(kSide * kSide);
    ASSERT_EQ(MIEN_OK, mien_score_model_get_latent(model_, -1, per_unit.data(), per_unit.size(),
                                                   &count, nullptr));
    EXPECT_EQ(per_unit.size(), count);
    const std::uint32_t middle = kSide * (kSide / 2) + kSide / 2;
    EXPECT_GT(std::abs(per_unit[middle]), 5 * std::abs(per_unit[0]));
    const Mesh face = make_mesh(*session_, graded_face(5, 1));
    mien_mesh* other = nullptr;
    ASSERT_EQ(MIEN_OK,
              mien_score_model_simulate(*session_, model_, face.get(), 3, &other, nullptr));
    // Two grades more: the middle lies deeper.
    EXPECT_LT(positions_of(other)[3 * middle + 2], positions_of(face.get())[3 * middle + 2] - 2);
    EXPECT_NEAR(3, predict(model_, other).score, 1.0);
    mien_mesh_release(other);
    EXPECT_EQ(MIEN_E_NOT_FOUND,
              mien_score_model_get_latent(model_, 1000, nullptr, 0, &count, nullptr));
}

TEST_F(Score, AFileKeepsThePredictions) {
    const std::string path = temporary_path("score.safetensors");
    ASSERT_EQ(MIEN_OK, mien_score_model_save(*session_, model_, path.c_str(), nullptr));
    mien_score_model* loaded = nullptr;
    ASSERT_EQ(MIEN_OK, mien_score_model_load(*session_, path.c_str(), &loaded, nullptr));
    mien_score_model_retain(loaded);
    mien_score_model_release(loaded);
    const Mesh face = make_mesh(*session_, graded_face(31, 2.5));
    EXPECT_EQ(predict(model_, face.get()).score, predict(loaded, face.get()).score);
    mien_score_model_release(loaded);
    std::remove(path.c_str());
    const std::string json = text_of([](char* dst, std::uint64_t capacity, std::uint64_t* count) {
        return mien_score_model_get_json(model_, dst, capacity, count, nullptr);
    });
    EXPECT_EQ(kSide * kSide, json_number(json, "vertices"));
    EXPECT_EQ(kFaces - 1, json_number(json, "samples"));
}

std::string agreement(const std::vector<std::int32_t>& ratings, std::uint32_t raters, int grades) {
    const Session session;
    return text_of([&](char* dst, std::uint64_t capacity, std::uint64_t* count) {
        return mien_statistics_agreement(session, ratings.data(), ratings.size() / raters, raters,
                                         grades, dst, capacity, count, nullptr);
    });
}

TEST(Statistics, RatersWhoAlwaysAgreeHaveAKappaOfOne) {
    const std::string json = agreement({0, 0, 1, 1, 2, 2, 1, 1, 0, 0}, 2, 3);
    EXPECT_EQ(1, json_number(json, "percent_agreement_all"));
    EXPECT_NEAR(1, json_number(json, "kappa"), 1e-12);
}

// Cohen 1960: 20 yes and 15 no in common, 5 and 10 apart give kappa 0.4.
TEST(Statistics, KappaOfATwoByTwoTableIsTheTextbooks) {
    std::vector<std::int32_t> ratings;
    const auto add = [&](int times, int a, int b) {
        for (int k = 0; k < times; ++k) ratings.insert(ratings.end(), {a, b});
    };
    add(20, 0, 0);
    add(5, 0, 1);
    add(10, 1, 0);
    add(15, 1, 1);
    const std::string json = agreement(ratings, 2, 2);
    EXPECT_NEAR(0.7, json_number(json, "percent_agreement_all"), 1e-12);
    const std::string pair = json.substr(json.find("\"percent_agreement\":"));
    EXPECT_NEAR(0.4, json_number(pair.substr(pair.find("{")), "kappa"), 1e-12);
}

TEST(Statistics, RepeatabilityIsThePooledDeviation) {
    const Session session;
    const double values[] = {10, 12, 20, 24, 30, 30}, blanks[] = {-1, 0, 1, 0};
    const std::int32_t subjects[] = {1, 1, 2, 2, 3, 3};
    const std::string json = text_of([&](char* dst, std::uint64_t capacity, std::uint64_t* count) {
        return mien_statistics_repeatability(session, values, subjects, 6, blanks, 4, dst, capacity,
                                             count, nullptr);
    });
    EXPECT_NEAR(std::sqrt((2 + 8 + 0) / 3.0), json_number(json, "within_subject_sd"), 1e-12);
    EXPECT_EQ(3, json_number(json, "degrees_of_freedom"));
    EXPECT_NEAR(0, json_number(json, "blank_mean"), 1e-12);
    EXPECT_GT(json_number(json, "limit_of_detection"), json_number(json, "limit_of_blank"));
}

TEST(Statistics, BlandAltmansBiasAndLimits) {
    const Session session;
    const double first[] = {1, 2, 3, 4}, second[] = {2, 2, 5, 5};
    const std::string json = text_of([&](char* dst, std::uint64_t capacity, std::uint64_t* count) {
        return mien_statistics_bland_altman(session, first, second, 4, dst, capacity, count,
                                            nullptr);
    });
    const double sd = std::sqrt(2.0 / 3);
    EXPECT_NEAR(1, std::abs(json_number(json, "bias")), 1e-12);
    EXPECT_NEAR(sd, json_number(json, "sd"), 1e-12);
    EXPECT_NEAR(2 * 1.96 * sd, json_number(json, "upper_limit") - json_number(json, "lower_limit"),
                1e-3);
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_statistics_bland_altman(session, first, second, 2,
                                                                    nullptr, 0, nullptr, nullptr));
}

}  // namespace
