#include <mien/mien.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>

#include "handles.hpp"

namespace {

using mien_test::fresh_error;

/// A sheet of side x side vertices whose middle bulges with the subject and whose edge lifts with
/// the expression.
struct Sheet {
    static constexpr int kSide = 12, kSubjects = 12;
    std::vector<mien::Triangle> triangles;

    Sheet() {
        for (int y = 0; y + 1 < kSide; ++y)
            for (int x = 0; x + 1 < kSide; ++x) {
                const auto a = static_cast<std::uint32_t>(y * kSide + x);
                triangles.push_back({a, a + 1, a + kSide});
                triangles.push_back({a + 1, a + kSide + 1, a + kSide});
            }
    }
    std::vector<mien::Position> face(int subject, int expression) const {
        std::vector<mien::Position> positions;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                double z = 0, lift = 0;
                for (int k = 1; k < 6; ++k)
                    z += 3 * std::sin(7.3 * subject + k) * std::sin(0.25 * k * x + 0.1 * k * k * y);
                if (expression == 1) lift = (5 + std::sin(3.1 * subject)) * std::exp(-0.3 * y);
                if (expression == 2)
                    lift = -(4 + std::cos(5.7 * subject)) * std::exp(-0.4 * (kSide - y));
                positions.push_back({10.0 * x, 10.0 * y + lift, z});
            }
        return positions;
    }
    std::string write_dataset(const mien::Session& session) const {
        const mien::Mesh topology(session, face(0, 0), triangles);
        const char* names[] = {"neutral", "up", "down"};
        mien_dataset_writer* writer = nullptr;
        EXPECT_EQ(MIEN_OK, mien_dataset_writer_create(session.get(), topology.get(), names, 3,
                                                      &writer, nullptr));
        for (int s = 0; s < kSubjects; ++s)
            for (int e = 0; e < 3; ++e) {
                const auto positions = face(s, e);
                const mien_array_view view{positions.data(), positions.size(),
                                           sizeof(mien::Position), MIEN_DTYPE_F64, 0};
                EXPECT_EQ(MIEN_OK, mien_dataset_writer_add(writer, &view, s, e, nullptr));
            }
        const std::string path = testing::TempDir() + "mien_abi_expression.safetensors";
        EXPECT_EQ(MIEN_OK, mien_dataset_writer_save(session.get(), writer, path.c_str(), nullptr));
        mien_dataset_writer_release(writer);
        return path;
    }
};

class Expression : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        session_ = new mien::Session(2);
        data_ = new std::string(sheet().write_dataset(*session_));
        mien::TrainOptions options;
        options.identity_modes = options.expression_modes = 5;
        model_ =
            new mien::ExpressionModel(mien::ExpressionModel::train(*session_, *data_, options));
    }
    static void TearDownTestSuite() {
        std::remove(data_->c_str());
        delete model_;
        delete data_;
        delete session_;
    }
    static const Sheet& sheet() {
        static const Sheet made;
        return made;
    }
    static mien::Mesh face(int subject, int expression) {
        return mien::Mesh(*session_, sheet().face(subject, expression), sheet().triangles);
    }
    static double distance(const std::vector<mien::Position>& a,
                           const std::vector<mien::Position>& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            sum += std::hypot(a[i][0] - b[i][0], a[i][1] - b[i][1], a[i][2] - b[i][2]);
        return sum / static_cast<double>(a.size());
    }
    static inline mien::Session* session_;
    static inline std::string* data_;
    static inline mien::ExpressionModel* model_;
};

TEST_F(Expression, NeutralizesAFaceTowardsItsNeutral) {
    mien::NeutralizeOptions options;
    options.uncertainty = 1;
    const mien::Neutralization result(*session_, *model_, face(20, 1), options);
    const auto truth = sheet().face(20, 0), before = sheet().face(20, 1);
    EXPECT_LT(distance(result.mesh().positions(), truth), 0.4 * distance(before, truth));
    EXPECT_EQ(result.uncertainty().size(), truth.size());
    EXPECT_NE(result.json().find("\"expression\":\"up\""), std::string::npos);
    EXPECT_EQ(result.mesh().triangles(), sheet().triangles);
}

TEST_F(Expression, NeutralizesAFitAsItNeutralizesItsMesh) {
    const std::vector<double> seen(Sheet::kSide * Sheet::kSide, 1.0);
    const mien::Registration fit(*session_, face(20, 1), seen, {}, {}, MIEN_QUALITY_GOOD);
    const mien::Neutralization of_fit(*session_, *model_, fit);
    EXPECT_EQ(of_fit.mesh().positions(),
              mien::Neutralization(*session_, *model_, face(20, 1)).mesh().positions());
    EXPECT_LT(distance(of_fit.mesh().positions(), sheet().face(20, 0)),
              0.4 * distance(sheet().face(20, 1), sheet().face(20, 0)));
}

// "alignment needs at least 3 points, got 700" was what the host heard of it.
TEST_F(Expression, AFitThatFailedIsRefusedInWordsThatSaySo) {
    const std::vector<double> unseen(Sheet::kSide * Sheet::kSide, 0.0);
    const mien::Registration fit(*session_, face(20, 1), unseen, {}, {}, MIEN_QUALITY_FAILED);
    try {
        const mien::Neutralization neutral(*session_, *model_, fit);
        FAIL() << "a failed fit was neutralized";
    } catch (const mien::Exception& refused) {
        EXPECT_EQ(MIEN_E_NO_SOLUTION, refused.status());
        EXPECT_NE(nullptr, std::strstr(refused.what(), "weight")) << refused.what();
        EXPECT_NE(nullptr, std::strstr(refused.what(), "failed")) << refused.what();
    }
}

TEST_F(Expression, AFaceIsTheMeanAndTheModesTimesTheirCoordinates) {
    const auto made = [](double identity, double expression) {
        std::vector<double> a(model_->identity_modes(), 0.0), b(model_->expression_modes(), 0.0);
        a.front() = identity;
        b.back() = expression;
        const mien_array_view identities{a.data(), a.size(), 0, MIEN_DTYPE_F64, 0},
            expressions{b.data(), b.size(), 0, MIEN_DTYPE_F64, 0};
        mien_mesh* mesh = nullptr;
        EXPECT_EQ(MIEN_OK,
                  mien_expression_model_synthesize(session_->get(), model_->get(), &identities,
                                                   &expressions, &mesh, nullptr));
        return mien::Mesh(mesh).positions();
    };
    const auto mean = made(0, 0), one = made(2, 0), other = made(0, 3), both = made(2, 3);
    EXPECT_GT(distance(mean, one), 0.01);
    EXPECT_GT(distance(mean, other), 0.01);
    for (std::size_t v = 0; v < mean.size(); ++v)
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(one[v][k] + other[v][k] - mean[v][k], both[v][k], 1e-9);
}

TEST_F(Expression, AChangedZoneIsReadBothWays) {
    // A person whose edge was lifted by treatment, much as the expression "up" lifts it.
    auto changed = sheet().face(26, 0);
    std::vector<std::uint32_t> zone;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < Sheet::kSide; ++x) {
            const int v = y * Sheet::kSide + x;
            changed[v][1] += 5 * std::exp(-0.3 * y);
            zone.push_back(static_cast<std::uint32_t>(v));
        }
    mien::NeutralizeOptions options;
    options.set_treated(zone);
    options.treated_margin_mm = 0;
    const mien::Mesh scan(*session_, changed, sheet().triangles);
    const mien::Neutralization result(*session_, *model_, scan, options);
    mien_zone_reading treated = {}, expression = {};
    treated.struct_size = expression.struct_size = sizeof treated;
    ASSERT_EQ(MIEN_OK, mien_neutralization_get_reading(result.get(), MIEN_READING_TREATED, &treated,
                                                       nullptr));
    ASSERT_EQ(MIEN_OK, mien_neutralization_get_reading(result.get(), MIEN_READING_AS_EXPRESSION,
                                                       &expression, nullptr));
    // As an expression most of the lift comes off; as a treatment it stays on.
    EXPECT_GT(expression.removed_mm, 1.5);
    EXPECT_LT(treated.removed_mm, 0.4 * expression.removed_mm);
    EXPECT_GT(treated.probability, 0);
    EXPECT_LE(treated.probability, 1);
    // What the result holds is the first reading.
    double squared = 0;
    const auto positions = result.mesh().positions();
    for (const std::uint32_t v : zone)
        for (int k = 0; k < 3; ++k) squared += std::pow(positions[v][k] - changed[v][k], 2);
    EXPECT_NEAR(std::sqrt(squared / static_cast<double>(zone.size())), treated.removed_mm, 0.3);
    EXPECT_EQ(treated.differ, expression.differ);
    EXPECT_EQ(MIEN_E_UNSUPPORTED_OPTION,
              mien_neutralization_get_reading(result.get(), 2, &treated, nullptr));
    const mien::Neutralization plain(*session_, *model_, scan);
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_neutralization_get_reading(plain.get(), MIEN_READING_TREATED,
                                                                &treated, nullptr));
}

TEST_F(Expression, TheReportTellsSizesAndExpressions) {
    const std::string json = model_->json();
    EXPECT_NE(std::string::npos, json.find("\"up\"")) << json;
    EXPECT_NE(std::string::npos, json.find("144")) << json;
    mien_expression_model_retain(model_->get());  // and gives it back
    mien_expression_model_release(model_->get());
    EXPECT_EQ(json, model_->json());
}

TEST_F(Expression, AModelFileGivesTheSameBits) {
    const std::string path = testing::TempDir() + "mien_abi_expression_model.safetensors";
    model_->save(*session_, path);
    const mien::ExpressionModel loaded(*session_, path);
    EXPECT_EQ(mien::Neutralization(*session_, *model_, face(21, 2)).mesh().positions(),
              mien::Neutralization(*session_, loaded, face(21, 2)).mesh().positions());
    EXPECT_EQ(loaded.identity_modes(), model_->identity_modes());
    std::ifstream file(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const mien::ExpressionModel copied =
        mien::ExpressionModel::load_memory(*session_, bytes.data(), bytes.size());
    std::fill(bytes.begin(), bytes.end(), '\0');
    EXPECT_EQ(mien::Neutralization(*session_, copied, face(21, 2)).mesh().positions(),
              mien::Neutralization(*session_, loaded, face(21, 2)).mesh().positions());
    std::remove(path.c_str());
}

TEST_F(Expression, ShardsMergeIntoTheModelOfASingleRun) {
    std::vector<std::string> shards;
    for (int part = 0; part < 2; ++part) {
        shards.push_back(testing::TempDir() + "mien_abi_shard" + std::to_string(part) +
                         ".safetensors");
        mien::ExpressionModel::write_shard(*session_, *data_, part, 2, shards.back());
    }
    mien::TrainOptions options;
    options.identity_modes = options.expression_modes = 5;
    const auto merged = mien::ExpressionModel::merge(*session_, shards, options);
    EXPECT_LT(distance(mien::Neutralization(*session_, *model_, face(22, 1)).mesh().positions(),
                       mien::Neutralization(*session_, merged, face(22, 1)).mesh().positions()),
              1e-6);
    for (const std::string& path : shards) std::remove(path.c_str());
}

TEST_F(Expression, SeriesScanAndTransferWork) {
    const std::vector<mien::Mesh> faces{face(23, 1), face(23, 2), face(23, 0)};
    const mien::Series series(*session_, *model_, faces);
    const auto truth = sheet().face(23, 0);
    EXPECT_LT(distance(series.identity().positions(), truth), 0.3);
    EXPECT_EQ(series.neutral(2).positions().size(), truth.size());
    EXPECT_THROW(series.neutral(3), mien::Exception);
    EXPECT_NE(series.json().find("distance_to_shared_mm"), std::string::npos);

    mien::SeriesOptions weighted;
    const std::vector<double> ones(truth.size() * faces.size(), 1.0);
    weighted.set_weights(ones);
    EXPECT_LT(
        distance(mien::Series(*session_, *model_, faces, weighted).identity().positions(), truth),
        0.3);
    const std::vector<double> too_few(truth.size(), 1.0);
    weighted.set_weights(too_few);
    EXPECT_THROW(mien::Series(*session_, *model_, faces, weighted), mien::Exception);

    const mien::Neutralization up(*session_, *model_, faces[0]),
        none(*session_, *model_, face(24, 0));
    EXPECT_LT(distance(up.apply_to_scan(*session_, faces[0]).positions(), up.mesh().positions()),
              0.3);
    const auto worn = up.transfer_to(*session_, *model_, none).positions();
    EXPECT_LT(distance(worn, sheet().face(24, 1)), 0.5 * distance(worn, sheet().face(24, 0)));
    EXPECT_EQ(model_->sample(*session_, 7, "up").positions(),
              model_->sample(*session_, 7, "up").positions());
}

TEST_F(Expression, VisitsOfOnePersonAreComparedWithoutTheirExpressions) {
    const std::vector<mien::Mesh> faces{face(23, 0), face(23, 1)};
    mien::VisitsOptions options;
    options.normal_noise_mm2 = 0.01;  // few vertices, which do not slide
    options.tangential_noise_mm2 = 0.01;
    std::vector<double> weights(2 * faces[0].vertex_count(), 1.0);
    options.set_weights(weights);
    const mien::Visits visits(*session_, *model_, faces, options);
    EXPECT_EQ(visits.expression(0), "neutral");
    EXPECT_EQ(visits.expression(1), "up");
    EXPECT_LT(distance(visits.neutral(1).positions(), sheet().face(23, 0)),
              0.5 * distance(faces[1].positions(), sheet().face(23, 0)));
    const mien::MeasureZone zone{"rim", {0, 1, 2, 3, 4, 5}};
    EXPECT_GT(visits.removed_volume(0, 1, zone).sd_ml, 0);
    EXPECT_EQ(visits.removed_volume(1, 1, zone).removed_ml, 0);
    EXPECT_THROW(visits.neutral(2), mien::Exception);
    EXPECT_THROW(visits.removed_volume(0, -1, zone), mien::Exception);
    weights.pop_back();
    options.set_weights(weights);
    EXPECT_THROW(mien::Visits(*session_, *model_, faces, options), mien::Exception);
    std::vector<std::uint32_t> beyond{100000};
    options = {};
    options.set_treated(beyond);
    EXPECT_THROW(mien::Visits(*session_, *model_, faces, options), mien::Exception);
}

TEST_F(Expression, EvaluationIsJsonWithEveryExpression) {
    mien::EvaluateOptions options;
    options.against = model_->get();
    const std::string json = model_->evaluate(*session_, *data_, options);
    for (const char* key : {"\"up\"", "\"down\"", "\"neutral\"", "\"all\"", "effect_over_against"})
        EXPECT_NE(json.find(key), std::string::npos) << key;
}

TEST_F(Expression, BadInputIsATypedError) {
    mien_error error = fresh_error();
    mien_neutralization* out = reinterpret_cast<mien_neutralization*>(1);
    EXPECT_EQ(MIEN_E_INVALID_HANDLE, mien_neutralize_mesh(session_->get(), nullptr,
                                                          face(1, 1).get(), nullptr, &out, &error));
    EXPECT_EQ(nullptr, out);
    EXPECT_EQ(MIEN_E_INVALID_HANDLE,
              mien_neutralize_mesh(session_->get(), model_->get(), nullptr, nullptr, &out, &error));
    const mien::Mesh small(*session_, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    EXPECT_EQ(MIEN_E_MISMATCH, mien_neutralize_mesh(session_->get(), model_->get(), small.get(),
                                                    nullptr, &out, &error));
    mien::NeutralizeOptions options;
    std::vector<double> weights(Sheet::kSide * Sheet::kSide, 1.0);
    weights[17] = std::numeric_limits<double>::quiet_NaN();
    options.set_weights(weights);
    const mien::Mesh good = face(1, 1);
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_neutralize_mesh(session_->get(), model_->get(),
                                                            good.get(), &options, &out, &error));
    EXPECT_EQ(17, error.detail_index);
    options = {};
    // A switch or an enumerator that this library does not know: one status for one mistake.
    const auto refused = [&](std::int32_t mien_neutralize_options::*member, std::int32_t value) {
        mien::NeutralizeOptions unknown;
        unknown.*member = value;
        return mien_neutralize_mesh(session_->get(), model_->get(), good.get(), &unknown, &out,
                                    &error);
    };
    EXPECT_EQ(MIEN_E_UNSUPPORTED_OPTION, refused(&mien_neutralize_options::method, 9));
    EXPECT_EQ(MIEN_E_UNSUPPORTED_OPTION, refused(&mien_neutralize_options::pose, 3));
    EXPECT_EQ(MIEN_E_UNSUPPORTED_OPTION, refused(&mien_neutralize_options::uncertainty, 2));
    mien_expression_model* model = nullptr;
    EXPECT_EQ(MIEN_E_WRONG_KIND,
              mien_expression_model_load(session_->get(), data_->c_str(), &model, &error));
    EXPECT_EQ(MIEN_E_IO, mien_expression_model_load(session_->get(), "/nowhere/x", &model, &error));
    const mien::Neutralization result(*session_, *model_, good);
    std::uint64_t count = 0;
    EXPECT_EQ(MIEN_E_NOT_FOUND,
              mien_neutralization_get_uncertainty(result.get(), nullptr, 0, &count, &error));
    EXPECT_EQ(nullptr, mien_neutralization_mesh(nullptr));
    mien_neutralization_release(nullptr);
    mien_expression_model_release(nullptr);
    mien_series_release(nullptr);
    mien_evaluation_release(nullptr);
}

TEST_F(Expression, AMeshOutlivesItsNeutralization) {
    mien::Mesh kept = mien::Neutralization(*session_, *model_, face(25, 1)).mesh();
    EXPECT_EQ(kept.positions().size(), static_cast<std::size_t>(Sheet::kSide * Sheet::kSide));
}

TEST_F(Expression, TrainingCanBeCancelled) {
    mien::TrainOptions options;
    options.identity_modes = options.expression_modes = 5;
    try {
        mien::ExpressionModel::train(*session_, *data_, options,
                                     [](int, double fraction) { return fraction < 0.3; });
        FAIL() << "not cancelled";
    } catch (const mien::Exception& exception) {
        EXPECT_EQ(MIEN_E_CANCELLED, exception.status());
    }
}

}  // namespace
