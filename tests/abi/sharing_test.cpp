// Immutable objects used by many threads at a time, each with a session of its own: the same bits
// as alone. Under ThreadSanitizer (preset tsan) this is the proof that they are immutable.
#include <atomic>
#include <thread>

#include "sheets.hpp"

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
