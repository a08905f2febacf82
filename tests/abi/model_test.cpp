// Deformation models through the shared library alone.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>

#include "handles.hpp"

namespace {

using namespace mien_test;

using Model = std::unique_ptr<mien_model, void (*)(mien_model*)>;

/// A bumpy grid of 11 x 11 vertices over 100 mm.
Mesh make_grid(mien_session* session) {
    std::vector<double> positions;
    std::vector<std::uint32_t> triangles;
    for (int y = 0; y < 11; ++y)
        for (int x = 0; x < 11; ++x) {
            positions.insert(positions.end(),
                             {10.0 * x, 10.0 * y, 5.0 * std::sin(0.7 * x) * std::cos(0.5 * y)});
            if (x < 10 && y < 10) {
                const auto a = static_cast<std::uint32_t>(11 * y + x);
                triangles.insert(triangles.end(), {a, a + 1, a + 12, a, a + 12, a + 11});
            }
        }
    mien_mesh_arrays arrays;
    mien_mesh_arrays_init(&arrays, sizeof arrays);
    arrays.positions = {positions.data(), 121, 0, MIEN_DTYPE_F64, 0};
    arrays.triangles = triangles.data();
    arrays.triangle_count = 200;
    mien_mesh* mesh = nullptr;
    EXPECT_EQ(MIEN_OK, mien_mesh_create(session, &arrays, &mesh, nullptr));
    return Mesh(mesh, mien_mesh_release);
}

mien_model_options small_options() {
    static const mien_landmark landmarks[] = {{"nose", 60, 0}, {"chin", 5, 0}};
    mien_model_options options;
    mien_model_options_init(&options, sizeof options);
    options.num_modes = 90;
    options.sigma_mm = 25;
    options.landmarks = landmarks;
    options.landmark_count = 2;
    return options;
}

Model build(mien_session* session, const mien_model_options& options) {
    mien_model* model = nullptr;
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_OK,
              mien_model_build(session, make_grid(session).get(), &options, &model, &error))
        << error.message;
    return Model(model, mien_model_release);
}

std::vector<double> positions_of(const mien_mesh* mesh) {
    std::vector<double> out(363);
    EXPECT_EQ(MIEN_OK,
              mien_mesh_get_positions(mesh, MIEN_DTYPE_F64, out.data(), 121, nullptr, nullptr));
    return out;
}

std::string json_of(const mien_model* model) {
    std::uint64_t size = 0;
    EXPECT_EQ(MIEN_OK, mien_model_get_json(model, nullptr, 0, &size, nullptr));
    std::string text(size, 'x');
    EXPECT_EQ(MIEN_OK, mien_model_get_json(model, &text[0], size, &size, nullptr));
    return text;
}

TEST(AbiModel, BuildsSavesAndLoadsTheSameModel) {
    Session session;
    const Model built = build(session, small_options());
    std::uint64_t vertices = 0, scalar = 0, vector = 9;
    EXPECT_EQ(MIEN_OK, mien_model_get_counts(built.get(), &vertices, &scalar, &vector, nullptr));
    EXPECT_EQ(vertices, 121u);
    EXPECT_EQ(scalar, 30u);
    EXPECT_EQ(vector, 0u);
    EXPECT_NE(json_of(built.get()).find("\"geodesic-se\""), std::string::npos);
    EXPECT_NE(json_of(built.get()).find("\"chin\":5"), std::string::npos);
    const std::string path = temporary_path("model.safetensors");
    ASSERT_EQ(MIEN_OK, mien_model_save(session, built.get(), path.c_str(), nullptr));
    for (auto load : {mien_model_load, mien_model_load_trusted}) {
        mien_model* loaded = nullptr;
        ASSERT_EQ(MIEN_OK, load(session, path.c_str(), &loaded, nullptr));
        EXPECT_EQ(json_of(loaded), json_of(built.get()));
        mien_mesh *a = nullptr, *b = nullptr;
        ASSERT_EQ(MIEN_OK, mien_model_sample(session, loaded, 5, 2, 1.0, &a, nullptr));
        ASSERT_EQ(MIEN_OK, mien_model_sample(session, built.get(), 5, 2, 1.0, &b, nullptr));
        EXPECT_EQ(positions_of(a), positions_of(b));
        mien_mesh_release(a);
        mien_mesh_release(b);
        mien_model_release(loaded);
    }
}

TEST(AbiModel, LoadsFromMemoryWhateverBecomesOfTheBytes) {
    Session session;
    const std::string path = temporary_path("memory.safetensors");
    ASSERT_EQ(MIEN_OK, mien_model_save(session, build(session, small_options()).get(), path.c_str(),
                                       nullptr));
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    std::vector<char> crooked(bytes.size() + 1);
    std::copy(bytes.begin(), bytes.end(), crooked.begin() + 1);
    mien_model *raw = nullptr, *conditioned = nullptr;
    mien_error error = fresh_error();
    ASSERT_EQ(MIEN_OK,
              mien_model_load_memory(session, crooked.data() + 1, bytes.size(), &raw, &error))
        << error.message;
    std::fill(crooked.begin(), crooked.end(), '\0');
    Model from_memory(raw, mien_model_release);
    ASSERT_EQ(MIEN_OK, mien_model_load(session, path.c_str(), &raw, &error)) << error.message;
    const Model from_file(raw, mien_model_release);
    EXPECT_EQ(json_of(from_memory.get()), json_of(from_file.get()));
    // A model made from it borrows its modes, and outlives it.
    const mien_landmark_observation seen{"nose", 0, 0, {50, 50, 3}, 1};
    ASSERT_EQ(MIEN_OK,
              mien_model_condition(session, from_memory.get(), &seen, 1, &conditioned, nullptr));
    from_memory.reset();
    const Model after(conditioned, mien_model_release);
    ASSERT_EQ(MIEN_OK, mien_model_condition(session, from_file.get(), &seen, 1, &raw, nullptr));
    const Model expected(raw, mien_model_release);
    const auto sample = [&](const mien_model* model) {
        mien_mesh* face = nullptr;
        EXPECT_EQ(MIEN_OK, mien_model_sample(session, model, 3, 0, 1, &face, nullptr));
        const std::vector<double> positions = positions_of(face);
        mien_mesh_release(face);
        return positions;
    };
    EXPECT_EQ(sample(after.get()), sample(expected.get()));
    // A size that is not the file's.
    for (const std::uint64_t size :
         {std::uint64_t{0}, std::uint64_t{bytes.size() - 1}, std::uint64_t{bytes.size() + 1},
          ~std::uint64_t{0}, ~std::uint64_t{0} >> 1})
        EXPECT_NE(MIEN_OK, mien_model_load_memory(session, bytes.data(), size, &raw, nullptr))
            << size;
    std::string damaged = bytes;
    damaged[damaged.size() - 5] ^= 1;
    EXPECT_EQ(MIEN_E_CORRUPT,
              mien_model_load_memory(session, damaged.data(), damaged.size(), &raw, nullptr));
    mien_expression_model* other = nullptr;
    EXPECT_EQ(MIEN_E_WRONG_KIND, mien_expression_model_load_memory(session, bytes.data(),
                                                                   bytes.size(), &other, nullptr));
    EXPECT_EQ(MIEN_E_MEMORY_BUDGET,
              mien_model_load_memory(Session(1, 1000), bytes.data(), bytes.size(), &raw, nullptr));
    std::remove(path.c_str());
}

TEST(AbiModel, TemplateOutlivesTheModelWhenRetained) {
    Session session;
    Model built = build(session, small_options());
    mien_mesh* mesh = const_cast<mien_mesh*>(mien_model_mesh(built.get()));
    mien_mesh_retain(mesh);
    const std::vector<double> before = positions_of(mesh);
    built.reset();
    EXPECT_EQ(positions_of(mesh), before);
    mien_mesh_release(mesh);
    EXPECT_EQ(mien_model_mesh(nullptr), nullptr);
}

TEST(AbiModel, ConditioningPullsTheMeanAndShrinksTheVariance) {
    Session session;
    const Model prior = build(session, small_options());
    const std::vector<double> rest = positions_of(mien_model_mesh(prior.get()));
    mien_landmark_observation seen{};
    seen.name = "nose";
    for (int c = 0; c < 3; ++c) seen.position[c] = rest[180 + static_cast<std::size_t>(c)] + 1.0;
    seen.noise_mm = 0.1;
    mien_model* raw = nullptr;
    ASSERT_EQ(MIEN_OK, mien_model_condition(session, prior.get(), &seen, 1, &raw, nullptr));
    const Model posterior(raw, mien_model_release);
    mien_mesh* mean = nullptr;
    ASSERT_EQ(MIEN_OK, mien_model_sample(session, posterior.get(), 0, 0, 0.0, &mean, nullptr));
    EXPECT_NEAR(positions_of(mean)[181], rest[181] + 1.0, 0.1);
    mien_mesh_release(mean);
    std::vector<double> before(363), after(363);
    std::uint64_t count = 0;
    ASSERT_EQ(MIEN_OK, mien_model_get_variance(prior.get(), before.data(), 121, &count, nullptr));
    EXPECT_EQ(count, 121u);
    ASSERT_EQ(MIEN_OK,
              mien_model_get_variance(posterior.get(), after.data(), 121, &count, nullptr));
    EXPECT_GT(before[180], 0.5);
    EXPECT_LE(after[180], 0.01001);
    seen.name = "ear";
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_model_condition(session, prior.get(), &seen, 1, &raw, &error));
    EXPECT_EQ(raw, nullptr);
    EXPECT_NE(std::string(error.message).find("ear"), std::string::npos);
}

TEST(AbiModel, TuningNamesTheBestSigma) {
    Session session;
    const Model truth = build(session, small_options());
    mien_dataset_writer* writer = nullptr;
    const char* names[] = {"neutral"};
    ASSERT_EQ(MIEN_OK, mien_dataset_writer_create(session, mien_model_mesh(truth.get()), names, 1,
                                                  &writer, nullptr));
    for (int k = 0; k < 3; ++k) {
        mien_mesh* face = nullptr;
        ASSERT_EQ(MIEN_OK, mien_model_sample(session, truth.get(), 1, static_cast<std::uint64_t>(k),
                                             3, &face, nullptr));
        const std::vector<double> x = positions_of(face);
        const mien_array_view view{x.data(), 121, 0, MIEN_DTYPE_F64, 0};
        ASSERT_EQ(MIEN_OK, mien_dataset_writer_add(writer, &view, k, 0, nullptr));
        mien_mesh_release(face);
    }
    const std::string path = temporary_path("tune.safetensors");
    ASSERT_EQ(MIEN_OK, mien_dataset_writer_save(session, writer, path.c_str(), nullptr));
    mien_dataset_writer_release(writer);
    const double sigmas[] = {6, 25, 90};
    mien_tune_options options;
    mien_tune_options_init(&options, sizeof options);
    options.sigmas_mm = sigmas;
    options.sigma_count = 3;
    options.num_modes = 90;
    options.rho = 0.1;
    mien_tuning* tuning = nullptr;
    mien_error error = fresh_error();
    ASSERT_EQ(MIEN_OK, mien_model_tune(session, mien_model_mesh(truth.get()), path.c_str(),
                                       &options, &tuning, &error))
        << error.message;
    char text[8192];
    ASSERT_EQ(MIEN_OK, mien_tuning_get_json(tuning, text, sizeof text, nullptr, nullptr));
    EXPECT_NE(std::strstr(text, "\"best_sigma_mm\":25"), nullptr) << text;
    mien_tuning_release(tuning);
    options.sigma_count = 0;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_model_tune(session, mien_model_mesh(truth.get()),
                                                       path.c_str(), &options, &tuning, nullptr));
    const char* wrong[] = {"smirk"};
    options.sigma_count = 3;
    options.expressions = wrong;
    options.expression_count = 1;
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_model_tune(session, mien_model_mesh(truth.get()), path.c_str(),
                                                &options, &tuning, nullptr));
}

TEST(AbiModel, WrongOptionsAreTypedErrorsAndTheSessionStillWorks) {
    Session session;
    const Mesh grid = make_grid(session);
    const auto status = [&](auto&& change) {
        mien_model_options options = small_options();
        change(options);
        mien_model* model = nullptr;
        mien_error error = fresh_error();
        const mien_status result = mien_model_build(session, grid.get(), &options, &model, &error);
        EXPECT_EQ(result == MIEN_OK, model != nullptr);
        EXPECT_EQ(result == MIEN_OK, error.message[0] == '\0');
        mien_model_release(model);
        return result;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(status([](mien_model_options& o) { o.kernel = 99; }), MIEN_E_UNSUPPORTED_OPTION);
    EXPECT_EQ(status([](mien_model_options& o) { o.kernel = MIEN_KERNEL_NONE; }),
              MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status([&](mien_model_options& o) { o.sigma_mm = nan; }), MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status([](mien_model_options& o) { o.levels = 0; }), MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status([](mien_model_options& o) { o.num_modes = 0; }), MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status([](mien_model_options& o) { o.num_modes = -5; }), MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status([](mien_model_options& o) { o.mirror_symmetric = 7; }),
              MIEN_E_UNSUPPORTED_OPTION);
    EXPECT_EQ(status([](mien_model_options& o) { o.mirror_symmetric = 1; }), MIEN_E_INVALID_MESH);
    EXPECT_EQ(status([](mien_model_options& o) { o.heat_boundary = 0; }),
              MIEN_E_UNSUPPORTED_OPTION);
    EXPECT_EQ(status([](mien_model_options& o) { o.landmarks = nullptr; }),
              MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status([](mien_model_options& o) { o.pca_dataset = "/nowhere/faces.safetensors"; }),
              MIEN_E_IO);
    EXPECT_EQ(status([](mien_model_options& o) { o.struct_size = 8; }), MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status([](mien_model_options&) {}), MIEN_OK);
    mien_model* model = nullptr;
    EXPECT_EQ(MIEN_E_INVALID_HANDLE, mien_model_build(session, nullptr, nullptr, &model, nullptr));
    EXPECT_EQ(MIEN_E_INVALID_HANDLE, mien_model_get_json(nullptr, nullptr, 0, nullptr, nullptr));
}

TEST(AbiModel, ValuesThatTheChosenKernelDoesNotReadMustStillBeNumbers) {
    Session session;
    const Mesh grid = make_grid(session);
    for (double mien_model_options::*field :
         {&mien_model_options::nu, &mien_model_options::pca_variance}) {
        mien_model_options options = small_options();
        options.*field = std::numeric_limits<double>::quiet_NaN();
        mien_model* model = nullptr;
        EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
                  mien_model_build(session, grid.get(), &options, &model, nullptr));
    }
}

TEST(AbiModel, ReservedFieldsAndAlignmentOfArraysOfStructsAreChecked) {
    Session session;
    const Model model = build(session, small_options());
    mien_model* out = nullptr;
    mien_landmark_observation seen[2] = {{"nose", 0, 0, {50, 50, 3}, 1},
                                         {"nose", 0, 7, {50, 50, 3}, 1}};
    EXPECT_EQ(MIEN_E_UNSUPPORTED_OPTION,
              mien_model_condition(session, model.get(), seen, 2, &out, nullptr));
    const auto* crooked =
        reinterpret_cast<const mien_landmark_observation*>(reinterpret_cast<const char*>(seen) + 1);
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_model_condition(session, model.get(), crooked, 1, &out, nullptr));
    mien_landmark nose{"nose", 60, 1};
    mien_model_options options = small_options();
    options.landmarks = &nose;
    options.landmark_count = 1;
    EXPECT_EQ(MIEN_E_UNSUPPORTED_OPTION,
              mien_model_build(session, make_grid(session).get(), &options, &out, nullptr));
}

TEST(AbiModel, CancelsAtEveryProgressPoint) {
    Session session;
    struct Counter {
        int calls, stop_at;
    } counter{0, 1 << 30};
    mien_model_options options = small_options();
    options.progress_user = &counter;
    options.progress = [](void* user, std::int32_t, double) -> std::int32_t {
        auto* c = static_cast<Counter*>(user);
        return ++c->calls >= c->stop_at;
    };
    build(session, options);
    const int all = counter.calls;
    EXPECT_GT(all, 3);
    const Mesh grid = make_grid(session);
    for (int stop = 1; stop <= all; ++stop) {
        counter = {0, stop};
        mien_model* model = nullptr;
        EXPECT_EQ(MIEN_E_CANCELLED,
                  mien_model_build(session, grid.get(), &options, &model, nullptr));
        EXPECT_EQ(model, nullptr);
    }
}

}  // namespace
