// Immutable objects used by many threads at a time, each with a session of its own: the same bits
// as alone. Under ThreadSanitizer (preset tsan) this is the proof that they are immutable.
#include <atomic>
#include <fstream>
#include <thread>

#include "sheets.hpp"
#include "small_network.hpp"

namespace {

using namespace mien_test;

constexpr int kThreads = 8, kRounds = 4;

/// Runs `work(session)` alone and then on many threads; every answer must be that of the first.
template <typename Work>
void expect_same_from_all_threads(Work&& work) {
    const std::vector<double> alone = work(Session());
    ASSERT_FALSE(alone.empty());
    std::atomic<int> different{0};
    std::vector<std::thread> threads;
    for (int k = 0; k < kThreads; ++k)
        threads.emplace_back([&] {
            const Session own(2);
            for (int round = 0; round < kRounds; ++round) different += work(own) != alone;
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(0, different.load());
}

class Sharing : public testing::Test {
  protected:
    void SetUp() override {
        mien_model_options options;
        mien_model_options_init(&options, sizeof options);
        options.num_modes = 30;
        options.num_control_points = 60;
        options.sigma_mm = 30;
        face_ = make_mesh(session_, sheet_arrays(12, 10, 8, 0.3));
        other_ = make_mesh(session_, sheet_arrays(12, 10, 8, 0.5));
        ASSERT_EQ(MIEN_OK, mien_model_build(session_, face_.get(), &options, &model_, nullptr));
    }
    void TearDown() override { mien_model_release(model_); }

    const Session session_;
    Mesh face_{nullptr, mien_mesh_release}, other_{nullptr, mien_mesh_release};
    mien_model* model_ = nullptr;
};

TEST_F(Sharing, AModelIsFittedByManyThreads) {
    expect_same_from_all_threads([&](mien_session* session) {
        mien_register_options options;
        mien_register_options_init(&options, sizeof options);
        options.start = MIEN_START_POSE;
        options.units = MIEN_UNITS_MILLIMETRES;
        options.iterations = 4;
        mien_registration* fit = nullptr;
        if (mien_register(session, model_, other_.get(), &options, &fit, nullptr) != MIEN_OK)
            return std::vector<double>();
        std::vector<double> places = positions_of(mien_registration_mesh(fit));
        mien_registration_release(fit);
        return places;
    });
}

TEST_F(Sharing, MeshesAreMeasuredByManyThreads) {
    expect_same_from_all_threads([&](mien_session* session) {
        std::vector<double> answers;
        mien_measurement* m = nullptr;
        if (mien_measure_distance(session, face_.get(), other_.get(), nullptr, &m, nullptr) !=
            MIEN_OK)
            return answers;
        mien_zone_distance d = {};
        d.struct_size = sizeof d;
        mien_measurement_get_distance(m, MIEN_ZONE_WHOLE, &d, nullptr);
        mien_measurement_release(m);
        double area = 0;
        mien_measure_area(session, face_.get(), nullptr, &area, nullptr);
        answers = {d.mean_signed_mm, d.max_length_mm, area};
        return answers;
    });
}

/// Twelve people, neutral and with their lower edge lifted.
std::string write_faces(mien_session* session, const mien_mesh* topology) {
    const char* names[] = {"neutral", "up"};
    mien_dataset_writer* writer = nullptr;
    EXPECT_EQ(MIEN_OK, mien_dataset_writer_create(session, topology, names, 2, &writer, nullptr));
    for (int person = 0; person < 12; ++person)
        for (int expression = 0; expression < 2; ++expression) {
            SheetArrays face = sheet_arrays(12, 10, 8, 0.1 * person);
            for (std::size_t v = 0; v < 144; ++v)
                face.positions[3 * v + 1] += expression * (5 + std::sin(3.1 * person)) *
                                             std::exp(-0.3 * static_cast<double>(v / 12));
            const mien_array_view view = {face.positions.data(), 144, 0, MIEN_DTYPE_F64, 0};
            EXPECT_EQ(MIEN_OK, mien_dataset_writer_add(writer, &view, person, expression, nullptr));
        }
    const std::string path = temporary_path("shared_faces.safetensors");
    EXPECT_EQ(MIEN_OK, mien_dataset_writer_save(session, writer, path.c_str(), nullptr));
    mien_dataset_writer_release(writer);
    return path;
}

TEST_F(Sharing, AnExpressionModelNeutralizesInManyThreads) {
    const std::string data = write_faces(session_, face_.get());
    mien_train_options train;
    mien_train_options_init(&train, sizeof train);
    train.identity_modes = train.expression_modes = 4;
    mien_expression_model* model = nullptr;
    mien_error error = fresh_error();
    ASSERT_EQ(MIEN_OK, mien_expression_model_train(session_, data.c_str(), &train, &model, &error))
        << error.message;
    expect_same_from_all_threads([&](mien_session* session) {
        mien_neutralization* neutral = nullptr;
        if (mien_neutralize_mesh(session, model, other_.get(), nullptr, &neutral, nullptr) !=
            MIEN_OK)
            return std::vector<double>();
        std::vector<double> places = positions_of(mien_neutralization_mesh(neutral));
        mien_neutralization_release(neutral);
        return places;
    });
    mien_expression_model_release(model);
}

TEST_F(Sharing, ASpectralBasisSplitsFacesInManyThreads) {
    mien_spectral_basis_options options;
    mien_spectral_basis_options_init(&options, sizeof options);
    options.mode_count = 20;
    mien_spectral_basis* basis = nullptr;
    ASSERT_EQ(MIEN_OK, mien_spectral_basis_build(session_, face_.get(), &options, &basis, nullptr));
    expect_same_from_all_threads([&](mien_session* session) {
        mien_mesh *low = nullptr, *high = nullptr;
        if (mien_spectral_split(session, basis, other_.get(), 12, &low, &high, nullptr) != MIEN_OK)
            return std::vector<double>();
        std::vector<double> places = positions_of(low);
        mien_mesh_release(low);
        mien_mesh_release(high);
        return places;
    });
    mien_spectral_basis_release(basis);
}

TEST_F(Sharing, ANetworkOfAMappedFileIsEvaluatedByManyThreads) {
    const SheetArrays sheet = sheet_arrays(12, 10, 8, 0.3);
    const std::string path = temporary_path("shared_network.safetensors");
    std::ofstream(path, std::ios::binary)
        << SmallNetwork(sheet.positions, sheet.triangles, 6).bytes();
    mien_network* network = nullptr;
    mien_error error = fresh_error();
    ASSERT_EQ(MIEN_OK, mien_network_load(session_, path.c_str(), &network, &error))
        << error.message;
    expect_same_from_all_threads([&](mien_session* session) {
        mien_mesh* made = nullptr;
        if (mien_network_apply(session, network, other_.get(), nullptr, &made, nullptr) != MIEN_OK)
            return std::vector<double>();
        std::vector<double> places = positions_of(made);
        mien_mesh_release(made);
        return places;
    });
    mien_network_release(network);
}

TEST_F(Sharing, ReferencesAreCountedByManyThreads) {
    std::vector<std::thread> threads;
    for (int k = 0; k < kThreads; ++k)
        threads.emplace_back([&] {
            for (int round = 0; round < 1000; ++round) {
                mien_model_retain(model_);
                mien_mesh* mesh = mien_mesh_retain(mien_model_mesh(model_));
                mien_mesh_release(mesh);
                mien_model_release(model_);
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(144u * 3, positions_of(mien_model_mesh(model_)).size());
}

}  // namespace
