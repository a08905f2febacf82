// What a session promises beside its results: one call at a time, a budget of memory, a limit of
// time.
#include <atomic>
#include <condition_variable>
#include <ctime>
#include <filesystem>
#include <mutex>
#include <thread>

#include "sheets.hpp"

namespace {

using namespace mien_test;

mien_model_options small_model() {
    mien_model_options options;
    mien_model_options_init(&options, sizeof options);
    options.num_modes = 12;
    options.num_control_points = 40;
    return options;
}

/// Lets a callback wait until the test says so.
struct Gate {
    std::mutex mutex;
    std::condition_variable changed;
    bool inside = false, open = false;
    static std::int32_t MIEN_CALL wait(void* user, std::int32_t, double) {
        auto* gate = static_cast<Gate*>(user);
        std::unique_lock<std::mutex> lock(gate->mutex);
        gate->inside = true;
        gate->changed.notify_all();
        gate->changed.wait(lock, [gate] { return gate->open; });
        return 0;
    }
};

// Two calls at a time on one pool waited for each other for ever.
TEST(Session, SharedByTwoThreadsIsBusyRatherThanHung) {
    const Session session(4);
    const Mesh mesh = make_sheet(session, 12);
    Gate gate;
    std::atomic<mien_status> first{1};
    std::thread other([&] {
        mien_model_options options = small_model();
        options.progress = &Gate::wait;
        options.progress_user = &gate;
        mien_model* model = nullptr;
        first = mien_model_build(session, mesh.get(), &options, &model, nullptr);
        mien_model_release(model);
    });
    {
        std::unique_lock<std::mutex> lock(gate.mutex);
        gate.changed.wait(lock, [&] { return gate.inside; });
    }
    mien_error error = fresh_error();
    mien_model* model = nullptr;
    const mien_model_options options = small_model();
    EXPECT_EQ(MIEN_E_BUSY, mien_model_build(session, mesh.get(), &options, &model, &error));
    EXPECT_NE(nullptr, std::strstr(error.message, "session"));
    EXPECT_EQ(nullptr, model);
    {
        const std::lock_guard<std::mutex> lock(gate.mutex);
        gate.open = true;
    }
    gate.changed.notify_all();
    other.join();
    EXPECT_EQ(MIEN_OK, first.load());
    EXPECT_EQ(MIEN_OK, mien_model_build(session, mesh.get(), &options, &model, nullptr));
    mien_model_release(model);
}

TEST(Session, HammeredByFourThreadsEndsEveryCall) {
    const Session session(4);
    const Mesh mesh = make_sheet(session, 12);
    std::atomic<int> good{0}, busy{0}, other{0};
    std::vector<std::thread> threads;
    for (int k = 0; k < 4; ++k)
        threads.emplace_back([&] {
            for (int round = 0; round < 25; ++round) {
                const mien_model_options options = small_model();
                mien_model* model = nullptr;
                const mien_status status =
                    mien_model_build(session, mesh.get(), &options, &model, nullptr);
                ++(status == MIEN_OK ? good : status == MIEN_E_BUSY ? busy : other);
                mien_model_release(model);
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(100, good + busy);
    EXPECT_EQ(0, other.load());
    EXPECT_GE(good.load(), 1);
}

TEST(Session, ACallbackMayCallAgain) {
    struct Again {
        mien_session* session;
        mien_status status = 1;
    };
    const Session session(2);
    const Mesh mesh = make_sheet(session, 12);
    Again again{session};
    mien_model_options options = small_model();
    options.progress_user = &again;
    options.progress = [](void* user, std::int32_t, double) -> std::int32_t {
        auto* a = static_cast<Again*>(user);
        a->status = make_square(a->session) == nullptr ? MIEN_E_INTERNAL : MIEN_OK;
        return 0;
    };
    mien_model* model = nullptr;
    EXPECT_EQ(MIEN_OK, mien_model_build(session, mesh.get(), &options, &model, nullptr));
    EXPECT_EQ(MIEN_OK, again.status);
    mien_model_release(model);
}

TEST(Session, ATimeLimitEndsALongCallSoonAfterIt) {
    mien_session_options options;
    mien_session_options_init(&options, sizeof options);
    options.max_seconds = 0.02;
    mien_session *hasty = nullptr, *patient = nullptr;
    ASSERT_EQ(MIEN_OK,
              mien_session_create_with_options(MIEN_ABI_VERSION, &options, &hasty, nullptr));
    options.max_seconds = 600;
    ASSERT_EQ(MIEN_OK,
              mien_session_create_with_options(MIEN_ABI_VERSION, &options, &patient, nullptr));
    const Session unlimited;
    const Mesh mesh = make_sheet(unlimited, 90), small = make_sheet(unlimited, 6);
    mien_model_options long_work = small_model();
    long_work.kernel = MIEN_KERNEL_SURFACE_MATERN;
    long_work.num_modes = 600;
    long_work.num_control_points = 0;
    mien_model* model = nullptr;
    mien_error error = fresh_error();
    const std::clock_t begin = std::clock();
    EXPECT_EQ(MIEN_E_TIME_LIMIT, mien_model_build(hasty, mesh.get(), &long_work, &model, &error));
    // Computing time: a busy machine is none of the library's.
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 1);
    EXPECT_NE(nullptr, std::strstr(error.message, "max_seconds"));
    const mien_model_options short_work = small_model();
    EXPECT_EQ(MIEN_OK, mien_model_build(patient, small.get(), &short_work, &model, &error))
        << error.message;
    mien_model_release(model);
    mien_session_release(hasty);
    mien_session_release(patient);
    for (const double wrong : {-1.0, 1e9, std::nan("")}) {
        options.max_seconds = wrong;
        EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
                  mien_session_create_with_options(MIEN_ABI_VERSION, &options, &hasty, nullptr));
    }
}

TEST(Session, ABudgetRefusesWhatNobodyEstimated) {
    const Session unlimited, tiny(1, 1000), enough(1, 64 << 20);
    const Mesh mesh = make_sheet(unlimited, 60);
    mien_model* model = nullptr;
    const mien_model_options options = small_model();
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_MEMORY_BUDGET, mien_model_build(tiny, mesh.get(), &options, &model, &error));
    EXPECT_NE(nullptr, std::strstr(error.message, "budget"));
    EXPECT_EQ(nullptr, model);
    EXPECT_EQ(MIEN_OK, mien_model_build(enough, mesh.get(), &options, &model, &error))
        << error.message;
    mien_model_release(model);
}

TEST(Session, ModelFilesMayBeCopiedInsteadOfMapped) {
    mien_session_options options;
    mien_session_options_init(&options, sizeof options);
    options.copy_files = 1;
    mien_session* session = nullptr;
    ASSERT_EQ(MIEN_OK,
              mien_session_create_with_options(MIEN_ABI_VERSION, &options, &session, nullptr));
    const Mesh mesh = make_sheet(session, 12);
    const mien_model_options small = small_model();
    mien_model* built = nullptr;
    ASSERT_EQ(MIEN_OK, mien_model_build(session, mesh.get(), &small, &built, nullptr));
    const std::string path = temporary_path("copied.safetensors");
    ASSERT_EQ(MIEN_OK, mien_model_save(session, built, path.c_str(), nullptr));
    mien_model* loaded = nullptr;
    ASSERT_EQ(MIEN_OK, mien_model_load(session, path.c_str(), &loaded, nullptr));
    // A mapped file that shrinks ends the process at the next look; a copied one is not looked at.
    std::filesystem::resize_file(path, 100);
    const std::string again = temporary_path("copied_again.safetensors");
    EXPECT_EQ(MIEN_OK, mien_model_save(session, loaded, again.c_str(), nullptr));
    mien_model_release(loaded);
    EXPECT_EQ(MIEN_OK, mien_model_load(session, again.c_str(), &loaded, nullptr));
    mien_model_release(loaded);
    mien_model_release(built);
    mien_session_release(session);
    options.copy_files = 2;
    EXPECT_EQ(MIEN_E_UNSUPPORTED_OPTION,
              mien_session_create_with_options(MIEN_ABI_VERSION, &options, &session, nullptr));
}

// A zeroed record said nothing about a failure.
TEST(Session, AZeroedErrorRecordIsWrittenToo) {
    mien_error error = {};
    mien_session* session = nullptr;
    EXPECT_EQ(MIEN_E_UNSUPPORTED_VERSION,
              mien_session_create(MIEN_ABI_VERSION + 1, &session, &error));
    EXPECT_EQ(MIEN_E_UNSUPPORTED_VERSION, error.status);
    EXPECT_NE('\0', error.message[0]);
    EXPECT_EQ(0u, error.struct_size);
}

// The way that the headers tell to keep a borrowed mesh did not compile in C++.
TEST(Mesh, ABorrowedMeshIsRetainedAsItComes) {
    const Session session;
    const Mesh mesh = make_sheet(session, 8);
    const mien_model_options options = small_model();
    mien_model* model = nullptr;
    ASSERT_EQ(MIEN_OK, mien_model_build(session, mesh.get(), &options, &model, nullptr));
    mien_mesh* own = mien_mesh_retain(mien_model_mesh(model));
    mien_model_release(model);
    std::uint64_t count = 0;
    EXPECT_EQ(MIEN_OK, mien_mesh_get_positions(own, MIEN_DTYPE_F64, nullptr, 0, &count, nullptr));
    EXPECT_EQ(64u, count);
    mien_mesh_release(own);
    EXPECT_EQ(nullptr, mien_mesh_retain(nullptr));
}

}  // namespace
