// The spectral room through the C++ face and the C functions beneath it.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <mien/mien.hpp>

namespace {

using namespace mien;

constexpr int kCells = 16;

std::vector<Position> bump(double height, double wave) {
    std::vector<Position> points;
    for (int j = 0; j <= kCells; ++j)
        for (int i = 0; i <= kCells; ++i) {
            const double x = 2.5 * i - 20, y = 2.5 * j - 20;
            points.push_back(
                {x + 0.2 * std::sin(y), y,
                 height * std::exp(-(x * x + y * y) / 200) + wave * std::cos(0.15 * x + 0.1 * y)});
        }
    return points;
}
std::vector<Triangle> cells() {
    std::vector<Triangle> triangles;
    for (std::uint32_t j = 0; j < kCells; ++j)
        for (std::uint32_t i = 0; i < kCells; ++i) {
            const std::uint32_t a = j * (kCells + 1) + i, b = a + 1, c = a + kCells + 1, d = c + 1;
            triangles.push_back({a, b, d});
            triangles.push_back({a, d, c});
        }
    return triangles;
}
Mesh face(const Session& session, double height, double wave) {
    return Mesh(session, bump(height, wave), cells());
}
double largest_difference(const Mesh& a, const Mesh& b) {
    const auto x = a.positions(), y = b.positions();
    double worst = 0;
    for (std::size_t v = 0; v < x.size(); ++v)
        for (std::size_t d = 0; d < 3; ++d) worst = std::max(worst, std::abs(x[v][d] - y[v][d]));
    return worst;
}
template <typename Body>
mien_status status_of(Body&& body) {
    try {
        body();
    } catch (const Exception& e) {
        return e.status();
    }
    return MIEN_OK;
}

class SpectralAbi : public ::testing::Test {
  protected:
    SpectralAbi() { std::filesystem::create_directories(folder_); }
    ~SpectralAbi() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    std::string file(const char* name) const { return (folder_ / name).string(); }
    SpectralBasis basis(std::uint32_t modes = 40) const {
        SpectralBasisOptions options;
        options.mode_count = modes;
        return SpectralBasis::build(session_, face(session_, 15, 0), options);
    }
    std::string dataset() const {
        DatasetWriter writer(session_, face(session_, 15, 0), {"neutral", "smile"});
        for (int s = 0; s < 6; ++s) {
            writer.add(bump(12 + s, 0.2 * s), s, 0);
            writer.add(bump(14 + s, 0.2 * s + 1), s, 1);
        }
        writer.save(session_, file("faces.safetensors"));
        return file("faces.safetensors");
    }
    Session session_{2};
    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() /
        ("mien-spectral-" +
         std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(SpectralAbi, BandsComeApartAndTogether) {
    const SpectralBasis b = basis();
    EXPECT_EQ(b.mode_count(), 40u);
    EXPECT_NEAR(b.eigenvalues()[0], 0.0, 1e-12);
    const Mesh given = face(session_, 17, 1);
    const Mesh low = b.low(session_, given, 30), high = b.high(session_, given, 30);
    EXPECT_LT(largest_difference(b.assemble(session_, low, high, 30), given), 1e-9);
    EXPECT_LT(largest_difference(b.edit(session_, given, {10, 30}, {1, 1, 1}), given), 1e-9);
    EXPECT_LT(largest_difference(b.edit(session_, given, {30}, {1, 0}), low), 1e-9);
    const Mesh other = face(session_, 10, 2);
    EXPECT_LT(largest_difference(b.mix(session_, given, other, {30}, {1, 1}), other), 1e-9);
    b.save(session_, file("basis.safetensors"));
    EXPECT_EQ(
        largest_difference(
            SpectralBasis::load(session_, file("basis.safetensors")).low(session_, given, 30), low),
        0.0);
}

TEST_F(SpectralAbi, BasisRefusesWhatIsOutOfRange) {
    const SpectralBasis b = basis();
    const Mesh given = face(session_, 17, 1);
    EXPECT_EQ(status_of([&] { b.low(session_, given, 41); }), MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { basis(100000); }), MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] {
                  b.edit(session_, given, {30, 20}, {1, 1, 1});
              }),
              MIEN_E_INVALID_ARGUMENT);
    const Mesh small(session_, std::vector<Position>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                     std::vector<Triangle>{{0, 1, 2}});
    EXPECT_EQ(status_of([&] { b.low(session_, small, 10); }), MIEN_E_MISMATCH);
    EXPECT_EQ(status_of([&] { SpectralBasis::load(session_, file("nothing")); }), MIEN_E_IO);
    mien_mesh* out = reinterpret_cast<mien_mesh*>(&out);
    EXPECT_EQ(mien_spectral_split(session_.get(), nullptr, given.get(), 3, &out, nullptr, nullptr),
              MIEN_E_INVALID_HANDLE);
    EXPECT_EQ(out, nullptr);
}

TEST_F(SpectralAbi, BuildingCanBeCancelled) {
    SpectralBasisOptions options;
    options.mode_count = 20;
    options.progress = [](int, double) { return false; };
    EXPECT_EQ(status_of([&] { SpectralBasis::build(session_, face(session_, 15, 0), options); }),
              MIEN_E_CANCELLED);
    Cancel cancel;
    cancel.request();
    options.progress = nullptr;
    options.cancel = cancel.get();
    EXPECT_EQ(status_of([&] { SpectralBasis::build(session_, face(session_, 15, 0), options); }),
              MIEN_E_CANCELLED);
}

TEST_F(SpectralAbi, MetricsTellFacesApart) {
    const Mesh a = face(session_, 15, 0), b = face(session_, 16, 0.5);
    for (std::int32_t kind = MIEN_METRIC_L1; kind <= MIEN_METRIC_FMPD; ++kind) {
        EXPECT_NEAR(metric(session_, kind, a, a), 0.0, 1e-12) << kind;
        EXPECT_GT(metric(session_, kind, a, b), 0.0) << kind;
    }
    EXPECT_EQ(status_of([&] { metric(session_, 99, a, b); }), MIEN_E_UNSUPPORTED_OPTION);
}

TEST_F(SpectralAbi, RepresentationsHaveTheirInverse) {
    const std::string path = dataset();
    const Mesh given = face(session_, 18, -0.5);
    for (std::int32_t kind = 1; kind <= 6; ++kind) {
        const Representation r = Representation::train(session_, path, kind);
        Representation::Motion motion{};
        const auto features = r.encode(session_, given, &motion);
        const Mesh back = r.decode(session_, features, &motion);
        // Deformations keep the mean's centre instead of the face's.
        EXPECT_LT(largest_difference(back, given), kind <= 3 ? 1e-8 : 2.0) << kind;
        EXPECT_EQ(r.channel_count(), kind <= 3 ? 3u : 9u);
    }
    const Representation r =
        Representation::train(session_, path, MIEN_FEATURES_DEFORMATION_NORMALISED, true);
    r.save(session_, file("r.safetensors"));
    EXPECT_EQ(Representation::load(session_, file("r.safetensors")).encode(session_, given),
              r.encode(session_, given));
    double bent_motion[12] = {2, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    const auto features = r.encode(session_, given);
    mien_mesh* out = nullptr;
    EXPECT_EQ(mien_representation_decode(session_.get(), r.get(), features.data(),
                                         features.size() / 9, bent_motion, &out, nullptr),
              MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(mien_representation_decode(session_.get(), r.get(), features.data(), 3, nullptr, &out,
                                         nullptr),
              MIEN_E_MISMATCH);
    std::uint64_t count = 0;
    double untouched = 7;
    EXPECT_EQ(mien_representation_encode(session_.get(), r.get(), given.get(), nullptr, &untouched,
                                         1, &count, nullptr),
              MIEN_E_BUFFER_TOO_SMALL);
    EXPECT_EQ(untouched, 7);
    EXPECT_EQ(count, std::uint64_t{(kCells + 1) * (kCells + 1)});
}

TEST_F(SpectralAbi, TrainingARepresentationReportsAndCanBeCancelled) {
    const std::string path = dataset();
    const Mesh given = face(session_, 18, -0.5);
    std::vector<double> fractions;
    const Representation r = Representation::train(session_, path, MIEN_FEATURES_DEFORMATION, false,
                                                   [&](std::int32_t, double fraction) {
                                                       fractions.push_back(fraction);
                                                       return true;
                                                   });
    EXPECT_GT(fractions.size(), 10u);
    EXPECT_EQ(fractions.back(), 1.0);
    EXPECT_EQ(status_of([&] {
                  Representation::train(
                      session_, path, MIEN_FEATURES_DEFORMATION, false,
                      [](std::int32_t stage, double) { return stage != MIEN_STAGE_TRAINING; });
              }),
              MIEN_E_CANCELLED);
    // Without options, and by the function of release 0.1: the same representation.
    for (const bool old : {false, true}) {
        mien_representation* bare = nullptr;
        mien_error error{};
        error.struct_size = sizeof error;
        const mien_status status =
            old ? mien_representation_train(session_.get(), path.c_str(), MIEN_FEATURES_DEFORMATION,
                                            0, &bare, &error)
                : mien_representation_train_with_options(session_.get(), path.c_str(),
                                                         MIEN_FEATURES_DEFORMATION, nullptr, &bare,
                                                         &error);
        ASSERT_EQ(status, MIEN_OK) << error.message;
        std::vector<double> features(9 * std::size_t{(kCells + 1) * (kCells + 1)});
        std::uint64_t count = 0;
        EXPECT_EQ(mien_representation_encode(session_.get(), bare, given.get(), nullptr,
                                             features.data(), features.size(), &count, &error),
                  MIEN_OK);
        EXPECT_EQ(features, r.encode(session_, given));
        mien_representation_release(bare);
    }
}

// The status of a wrong switch was invalid_argument in some calls and unsupported_option in others.
TEST_F(SpectralAbi, UnknownSwitchesAndEnumeratorsHaveOneStatusEverywhere) {
    const Mesh mesh = face(session_, 15, 0);
    const std::string path = dataset();
    mien_representation* representation = nullptr;
    mien_measurement* measurement = nullptr;
    double number = 0;
    EXPECT_EQ(
        mien_representation_train(session_.get(), path.c_str(), 99, 0, &representation, nullptr),
        MIEN_E_UNSUPPORTED_OPTION);
    EXPECT_EQ(
        mien_representation_train(session_.get(), path.c_str(), 1, 7, &representation, nullptr),
        MIEN_E_UNSUPPORTED_OPTION);
    EXPECT_EQ(mien_metric(session_.get(), 99, mesh.get(), mesh.get(), &number, nullptr),
              MIEN_E_UNSUPPORTED_OPTION);
    EXPECT_EQ(mien_measure_closed_volume(session_.get(), mesh.get(), 7, &number, nullptr),
              MIEN_E_UNSUPPORTED_OPTION);
    EXPECT_EQ(
        mien_measure_curvature(session_.get(), mesh.get(), 8, 7, nullptr, &measurement, nullptr),
        MIEN_E_UNSUPPORTED_OPTION);
    mien_measure_options options;
    mien_measure_options_init(&options, sizeof options);
    options.skip_borders = 7;
    EXPECT_EQ(
        mien_measure_curvature(session_.get(), mesh.get(), 8, 1, &options, &measurement, nullptr),
        MIEN_E_UNSUPPORTED_OPTION);
    const Hierarchy levels = Hierarchy::quadric(session_, mesh, 1, 3.0);
    const std::vector<double> ones(mesh.vertex_count(), 1.0);
    EXPECT_EQ(status_of([&] { levels.apply(1, 7, ones, 1); }), MIEN_E_UNSUPPORTED_OPTION);
}

TEST_F(SpectralAbi, HierarchiesMapUpAndDown) {
    const Mesh mesh = face(session_, 15, 0.5);
    for (const Hierarchy& h : {Hierarchy::quadric(session_, mesh, 2, 3.0),
                               Hierarchy::connectivity(session_, mesh, 2, 2, 1)}) {
        ASSERT_EQ(h.level_count(), 3u);
        const std::size_t fine = h.level(0).vertex_count(), coarse = h.level(1).vertex_count();
        EXPECT_LT(coarse, fine);
        const auto down = h.apply(1, MIEN_MAP_DOWN, std::vector<double>(2 * fine, 3.0), 2);
        ASSERT_EQ(down.size(), 2 * coarse);
        for (const double value : h.apply(1, MIEN_MAP_UP, down, 2)) EXPECT_NEAR(value, 3.0, 1e-12);
        h.save(session_, file("h.safetensors"));
        EXPECT_EQ(Hierarchy::load(session_, file("h.safetensors")).level(2).vertex_count(),
                  h.level(2).vertex_count());
        EXPECT_EQ(status_of([&] { h.apply(0, MIEN_MAP_UP, down, 2); }), MIEN_E_INVALID_ARGUMENT);
        EXPECT_EQ(status_of([&] { h.level(9); }), MIEN_E_INVALID_ARGUMENT);
    }
}

TEST_F(SpectralAbi, ExpressionsAreCarriedAndPredicted) {
    const Mesh neutral = face(session_, 15, 0), smile = face(session_, 17, 1);
    EXPECT_LT(largest_difference(transfer_expression(session_, neutral, smile, neutral), smile),
              1e-7);
    const std::string path = dataset();
    const BlendshapeModel model = BlendshapeModel::train(session_, path, "smile");
    const SpectralBasis b = SpectralBasis::build(session_, model.mean(), [] {
        SpectralBasisOptions options;
        options.mode_count = 50;
        return options;
    }());
    const Mesh new_neutral = face(session_, 14.5, 0.5), truth = face(session_, 16.5, 1.5);
    EXPECT_LT(metric(session_, MIEN_METRIC_L1, model.predict(session_, new_neutral, &b, 30), truth),
              0.3 * metric(session_, MIEN_METRIC_L1, new_neutral, truth));
    const auto choices = model.search(session_, b, path, "smile", {0, 10, 50, 1000});
    ASSERT_EQ(choices.size(), 4u);
    int chosen = 0;
    for (const auto& c : choices) chosen += c.chosen;
    EXPECT_EQ(chosen, 1);
    model.save(session_, file("m.safetensors"));
    EXPECT_LT(largest_difference(BlendshapeModel::load(session_, file("m.safetensors"))
                                     .predict(session_, new_neutral, nullptr, 1),
                                 model.predict(session_, new_neutral, nullptr, 1)),
              1e-9);
    EXPECT_EQ(status_of([&] { BlendshapeModel::train(session_, path, "frown"); }),
              MIEN_E_NOT_FOUND);
    EXPECT_EQ(status_of([&] { SpectralBasis::load(session_, file("m.safetensors")); }),
              MIEN_E_WRONG_KIND);
}

/// Loads an object of C, takes a reference, gives the first back: the second still holds it.
template <typename Handle, typename Load, typename Use>
void expect_kept_by_a_reference(Load load, const Session& session, const std::string& path,
                                void (*retain)(Handle*), void (*release)(Handle*), Use&& use) {
    Handle* handle = nullptr;
    ASSERT_EQ(MIEN_OK, load(session.get(), path.c_str(), &handle, nullptr)) << path;
    retain(handle);
    release(handle);
    EXPECT_EQ(MIEN_OK, use(handle)) << path;
    release(handle);
    retain(nullptr);
}

TEST_F(SpectralAbi, AReferenceKeepsWhatIsLoaded) {
    const std::string path = dataset();
    basis().save(session_, file("b"));
    Hierarchy::quadric(session_, face(session_, 15, 0.5), 1, 3.0).save(session_, file("h"));
    Representation::train(session_, path, MIEN_FEATURES_EUCLIDEAN).save(session_, file("r"));
    BlendshapeModel::train(session_, path, "smile").save(session_, file("m"));
    expect_kept_by_a_reference(
        mien_spectral_basis_load, session_, file("b"), mien_spectral_basis_retain,
        mien_spectral_basis_release, [](const mien_spectral_basis* b) {
            std::uint64_t vertices = 0;
            std::uint64_t modes = 0;
            return mien_spectral_basis_get_counts(b, &vertices, &modes, nullptr);
        });
    expect_kept_by_a_reference(mien_hierarchy_load, session_, file("h"), mien_hierarchy_retain,
                               mien_hierarchy_release, [](const mien_hierarchy* h) {
                                   std::uint32_t levels = 0;
                                   return mien_hierarchy_get_level_count(h, &levels, nullptr);
                               });
    expect_kept_by_a_reference(
        mien_representation_load, session_, file("r"), mien_representation_retain,
        mien_representation_release, [](const mien_representation* r) {
            std::uint64_t channels = 0;
            return mien_representation_get_counts(r, nullptr, &channels, nullptr);
        });
    expect_kept_by_a_reference(
        mien_blendshape_model_load, session_, file("m"), mien_blendshape_model_retain,
        mien_blendshape_model_release, [](const mien_blendshape_model* m) {
            mien_mesh* mean = nullptr;
            const mien_status status = mien_blendshape_model_get_mean(m, &mean, nullptr);
            mien_mesh_release(mean);
            return status;
        });
}

}  // namespace
