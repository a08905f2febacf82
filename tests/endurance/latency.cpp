// How long after a cancel a call goes on. Long calls on inputs of real size are cancelled at many
// moments; what counts is computing time, because a busy machine is none of the library's.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "endurance.hpp"

namespace endurance {
namespace {

constexpr int kSide = 60, kSubjects = 40, kExpressions = 4;
constexpr double kBarMs = 50;

double seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::vector<double> face(int subject, int expression) {
    std::vector<double> positions;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            double z = 20 * std::cos(0.05 * (x - 30)) * std::cos(0.05 * (y - 30));
            for (int k = 1; k < 9; ++k)
                z += 0.7 * std::sin(7.3 * subject * k) * std::sin(0.07 * k * x + 0.03 * k * k * y);
            const double lift = expression * (3 + std::sin(2.1 * subject * expression)) *
                                std::exp(-0.01 * (x - 20) * (x - 20) - 0.02 * y * expression);
            positions.insert(positions.end(), {2.5 * x, 2.5 * y + lift, 2.0 * z + 0.3 * lift});
        }
    return positions;
}

/// What the calls work on.
class Inputs {
  public:
    Inputs() : session_(new_session()) {
        std::vector<std::uint32_t> triangles;
        for (std::uint32_t y = 0; y + 1 < kSide; ++y)
            for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
                const std::uint32_t a = y * kSide + x;
                triangles.insert(triangles.end(),
                                 {a, a + 1, a + kSide + 1, a, a + kSide + 1, a + kSide});
            }
        const auto mesh_of = [&](int subject, int expression) {
            const std::vector<double> positions = face(subject, expression);
            mien_mesh_arrays arrays;
            mien_mesh_arrays_init(&arrays, sizeof arrays);
            arrays.positions = {positions.data(), positions.size() / 3, 0, MIEN_DTYPE_F64, 0};
            arrays.triangles = triangles.data();
            arrays.triangle_count = triangles.size() / 3;
            mien_mesh* mesh = nullptr;
            if (mien_mesh_create(session_, &arrays, &mesh, nullptr) != MIEN_OK) fault("no mesh");
            return mesh;
        };
        mesh_ = mesh_of(0, 0);
        scan_ = mesh_of(99, 1);
        write_dataset();
        mien_model_options options;
        mien_model_options_init(&options, sizeof options);
        options.num_modes = 300;
        if (mien_model_build(session_, mesh_, &options, &model_, nullptr) != MIEN_OK)
            fault("no model");
    }
    ~Inputs() {
        mien_model_release(model_);
        mien_mesh_release(scan_);
        mien_mesh_release(mesh_);
        mien_session_release(session_);
    }
    Inputs(const Inputs&) = delete;
    Inputs& operator=(const Inputs&) = delete;

    mien_session* session() const { return session_; }
    const mien_mesh* mesh() const { return mesh_; }
    const mien_mesh* scan() const { return scan_; }
    const mien_model* model() const { return model_; }
    static constexpr const char* kDataset = "latency_faces.safetensors";

  private:
    void write_dataset() {
        const char* const names[kExpressions] = {"neutral", "grin", "pout", "gape"};
        mien_dataset_writer* writer = nullptr;
        mien_dataset_writer_create(session_, mesh_, names, kExpressions, &writer, nullptr);
        for (int subject = 0; subject < kSubjects; ++subject)
            for (int expression = 0; expression < kExpressions; ++expression) {
                const std::vector<double> positions = face(subject, expression);
                const mien_array_view view{positions.data(), positions.size() / 3, 0,
                                           MIEN_DTYPE_F64, 0};
                mien_dataset_writer_add(writer, &view, subject, expression, nullptr);
            }
        if (mien_dataset_writer_save(session_, writer, kDataset, nullptr) != MIEN_OK)
            fault("no dataset");
        mien_dataset_writer_release(writer);
    }

    mien_session* session_;
    mien_mesh *mesh_ = nullptr, *scan_ = nullptr;
    mien_model* model_ = nullptr;
};

struct LongCall {
    const char* name;
    std::function<mien_status(mien_cancel*, mien_error*)> run;
};

/// The status; what was made is given back.
template <typename Handle>
mien_status released(mien_status status, Handle*& made, void (*release)(Handle*)) {
    release(made);
    return status;
}

std::vector<LongCall> long_calls(const Inputs& in) {
    const auto build = [&in](std::int32_t kernel, const char* faces, mien_cancel* cancel,
                             mien_error* error) {
        mien_model_options o;
        mien_model_options_init(&o, sizeof o);
        o.kernel = kernel;
        o.num_modes = 900;
        o.pca_dataset = faces;
        o.cancel = cancel;
        mien_model* made = nullptr;
        return released(mien_model_build(in.session(), in.mesh(), &o, &made, error), made,
                        mien_model_release);
    };
    return {
        {"model build, geodesic",
         [build](mien_cancel* c, mien_error* e) {
             return build(MIEN_KERNEL_GEODESIC_SE, nullptr, c, e);
         }},
        {"model build, surface Matern and trained modes",
         [build](mien_cancel* c, mien_error* e) {
             return build(MIEN_KERNEL_SURFACE_MATERN, Inputs::kDataset, c, e);
         }},
        {"expression train",
         [&in](mien_cancel* c, mien_error* e) {
             mien_train_options o;
             mien_train_options_init(&o, sizeof o);
             o.cancel = c;
             mien_expression_model* made = nullptr;
             return released(
                 mien_expression_model_train(in.session(), Inputs::kDataset, &o, &made, e), made,
                 mien_expression_model_release);
         }},
        {"blendshapes train",
         [&in](mien_cancel* c, mien_error* e) {
             mien_blendshape_options o;
             mien_blendshape_options_init(&o, sizeof o);
             o.cancel = c;
             mien_blendshape_model* made = nullptr;
             return released(
                 mien_blendshape_model_train(in.session(), Inputs::kDataset, "grin", &o, &made, e),
                 made, mien_blendshape_model_release);
         }},
        {"spectral basis",
         [&in](mien_cancel* c, mien_error* e) {
             mien_spectral_basis_options o;
             mien_spectral_basis_options_init(&o, sizeof o);
             o.mode_count = 1000;
             o.cancel = c;
             mien_spectral_basis* made = nullptr;
             return released(mien_spectral_basis_build(in.session(), in.mesh(), &o, &made, e), made,
                             mien_spectral_basis_release);
         }},
        {"score train",
         [&in](mien_cancel* c, mien_error* e) {
             mien_score_options o;
             mien_score_options_init(&o, sizeof o);
             o.cancel = c;
             std::vector<double> grades;
             for (int k = 0; k < kSubjects * kExpressions; ++k) grades.push_back(k % 4);
             mien_score_model* made = nullptr;
             return released(mien_score_model_train(in.session(), Inputs::kDataset, grades.data(),
                                                    grades.size(), &o, &made, e),
                             made, mien_score_model_release);
         }},
        {"register with a search",
         [&in](mien_cancel* c, mien_error* e) {
             mien_register_options o;
             mien_register_options_init(&o, sizeof o);
             o.start = MIEN_START_SEARCH;
             o.cancel = c;
             mien_registration* made = nullptr;
             return released(mien_register(in.session(), in.model(), in.scan(), &o, &made, e), made,
                             mien_registration_release);
         }},
        {"curvature",
         [&in](mien_cancel* c, mien_error* e) {
             mien_measure_options o;
             mien_measure_options_init(&o, sizeof o);
             o.cancel = c;
             mien_measurement* made = nullptr;
             return released(mien_measure_curvature(in.session(), in.mesh(), 20, 1, &o, &made, e),
                             made, mien_measurement_release);
         }},
    };
}

/// Milliseconds of computing between a cancel after `share` of the call's time and its end; below 0
/// when the call was over before.
double late_ms(const LongCall& call, double whole_s, double share) {
    mien_cancel* cancel = nullptr;
    mien_cancel_create(&cancel, nullptr);
    std::atomic<bool> over{false};
    double asked_s = -1;
    const double begin_s = seconds();
    std::thread watcher([&] {
        while (!over && seconds() - begin_s < share * whole_s)
            std::this_thread::sleep_for(std::chrono::microseconds(300));
        if (over) return;
        asked_s = seconds();
        mien_cancel_request(cancel);
    });
    mien_error error = {};
    error.struct_size = sizeof error;
    const mien_status status = call.run(cancel, &error);
    const double end_s = seconds();
    over = true;
    watcher.join();
    mien_cancel_release(cancel);
    if (status != MIEN_OK && status != MIEN_E_CANCELLED)
        fault(std::string(call.name) + " ends as " + mien_status_name(status) + ": " +
              error.message);
    return status == MIEN_E_CANCELLED && asked_s >= 0 ? 1e3 * (end_s - asked_s) : -1;
}

}  // namespace

void run_latency(long count) {
    const Inputs inputs;
    for (const LongCall& call : long_calls(inputs)) {
        const double begin_s = seconds();
        mien_error error = {};
        error.struct_size = sizeof error;
        if (call.run(nullptr, &error) != MIEN_OK)
            fault(std::string(call.name) + " fails: " + error.message);
        const double whole_s = seconds() - begin_s;
        double latest_ms = -1, at = 0;
        long cancelled = 0;
        for (long k = 0; k < count; ++k) {
            const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
            const double late = late_ms(call, whole_s, share);
            cancelled += late >= 0;
            if (late <= latest_ms) continue;
            latest_ms = late;
            at = share;
        }
        std::printf("%-46s %7.2f s, %3ld cancels, at most %6.1f ms late (after %.0f %%)\n",
                    call.name, whole_s, cancelled, latest_ms, 100 * at);
        std::fflush(stdout);
        if (latest_ms > kBarMs)
            fault(std::string(call.name) + " goes on for " + std::to_string(latest_ms) + " ms");
    }
}

}  // namespace endurance
