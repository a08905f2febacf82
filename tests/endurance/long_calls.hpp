// Long calls on inputs of real size: what is cancelled and what is held to its memory.
#pragma once

#include <mien/mien.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace endurance {

/// A sheet like a face, of side x side vertices, 150 mm wide.
class FaceSheet {
  public:
    explicit FaceSheet(int side) : side_(side) {
        const auto n = static_cast<std::uint32_t>(side);
        for (std::uint32_t y = 0; y + 1 < n; ++y)
            for (std::uint32_t x = 0; x + 1 < n; ++x) {
                const std::uint32_t a = y * n + x;
                triangles_.insert(triangles_.end(), {a, a + 1, a + n + 1, a, a + n + 1, a + n});
            }
    }
    std::vector<double> positions(int subject, int expression) const {
        std::vector<double> positions;
        const double cell = 60.0 / side_;
        for (int j = 0; j < side_; ++j)
            for (int i = 0; i < side_; ++i) {
                const double x = cell * i, y = cell * j;
                double z = 20 * std::cos(0.05 * (x - 30)) * std::cos(0.05 * (y - 30));
                for (int k = 1; k < 9; ++k)
                    z += 0.7 * std::sin(7.3 * subject * k) *
                         std::sin(0.07 * k * x + 0.03 * k * k * y);
                const double lift = expression * (3 + std::sin(2.1 * subject * expression)) *
                                    std::exp(-0.01 * (x - 20) * (x - 20) - 0.02 * y * expression);
                positions.insert(positions.end(), {2.5 * x, 2.5 * y + lift, 2.0 * z + 0.3 * lift});
            }
        return positions;
    }
    mien_mesh* mesh(mien_session* session, int subject, int expression) const {
        const std::vector<double> places = positions(subject, expression);
        mien_mesh_arrays arrays;
        mien_mesh_arrays_init(&arrays, sizeof arrays);
        arrays.positions = {places.data(), places.size() / 3, 0, MIEN_DTYPE_F64, 0};
        arrays.triangles = triangles_.data();
        arrays.triangle_count = triangles_.size() / 3;
        mien_mesh* mesh = nullptr;
        if (mien_mesh_create(session, &arrays, &mesh, nullptr) != MIEN_OK)
            throw std::runtime_error("no mesh");
        return mesh;
    }

  private:
    int side_;
    std::vector<std::uint32_t> triangles_;
};

/// What the calls work on: a template of 3,600 vertices, a scan of 90,000, 160 faces, models.
class Inputs {
  public:
    static constexpr int kSide = 60, kScanSide = 300, kSubjects = 40, kExpressions = 4;
    static constexpr const char* kDataset = "long_faces.safetensors";
    static constexpr const char* kScan = "long_scan.ply";

    Inputs() {
        check(mien_session_create(MIEN_ABI_VERSION, &session_, nullptr), "session");
        const FaceSheet sheet(kSide);
        mesh_ = sheet.mesh(session_, 0, 0);
        scan_ = sheet.mesh(session_, 99, 1);
        dense_ = FaceSheet(kScanSide).mesh(session_, 99, 1);
        check(mien_mesh_save(session_, dense_, kScan, nullptr), "scan file");
        write_dataset(sheet);
        mien_model_options options;
        mien_model_options_init(&options, sizeof options);
        options.num_modes = 300;
        check(mien_model_build(session_, mesh_, &options, &model_, nullptr), "model");
        check(mien_expression_model_train(session_, kDataset, nullptr, &expressions_, nullptr),
              "expressions");
    }
    ~Inputs() {
        mien_expression_model_release(expressions_);
        mien_model_release(model_);
        mien_mesh_release(dense_);
        mien_mesh_release(scan_);
        mien_mesh_release(mesh_);
        mien_session_release(session_);
    }
    Inputs(const Inputs&) = delete;
    Inputs& operator=(const Inputs&) = delete;

    mien_session* session() const { return session_; }
    const mien_mesh* mesh() const { return mesh_; }
    const mien_mesh* scan() const { return scan_; }
    const mien_mesh* dense() const { return dense_; }
    const mien_model* model() const { return model_; }
    const mien_expression_model* expressions() const { return expressions_; }

  private:
    static void check(mien_status status, const char* what) {
        if (status != MIEN_OK)
            throw std::runtime_error(std::string("no ") + what + ": " + mien_status_name(status));
    }
    void write_dataset(const FaceSheet& sheet) {
        const char* const names[kExpressions] = {"neutral", "grin", "pout", "gape"};
        mien_dataset_writer* writer = nullptr;
        check(mien_dataset_writer_create(session_, mesh_, names, kExpressions, &writer, nullptr),
              "writer");
        for (int subject = 0; subject < kSubjects; ++subject)
            for (int expression = 0; expression < kExpressions; ++expression) {
                const std::vector<double> places = sheet.positions(subject, expression);
                const mien_array_view view{places.data(), places.size() / 3, 0, MIEN_DTYPE_F64, 0};
                mien_dataset_writer_add(writer, &view, subject, expression, nullptr);
            }
        check(mien_dataset_writer_save(session_, writer, kDataset, nullptr), "dataset");
        mien_dataset_writer_release(writer);
    }

    mien_session* session_ = nullptr;
    mien_mesh *mesh_ = nullptr, *scan_ = nullptr, *dense_ = nullptr;
    mien_model* model_ = nullptr;
    mien_expression_model* expressions_ = nullptr;
};

struct LongCall {
    const char* name;
    bool cancels;  ///< takes a cancel token
    std::function<mien_status(mien_session*, mien_cancel*, mien_error*)> run;
};

/// The status; what was made is given back.
template <typename Handle>
mien_status released(mien_status status, Handle*& made, void (*release)(Handle*)) {
    release(made);
    return status;
}

/// Options with their defaults and this token.
template <typename Options>
Options with_cancel(void (*init)(Options*, std::size_t), mien_cancel* cancel) {
    Options options;
    init(&options, sizeof options);
    options.cancel = cancel;
    return options;
}

inline mien_status build_long_model(const Inputs& in, std::int32_t kernel, const char* faces,
                                    mien_session* session, mien_cancel* cancel, mien_error* error) {
    auto o = with_cancel(mien_model_options_init, cancel);
    o.kernel = kernel;
    o.num_modes = 900;
    o.pca_dataset = faces;
    mien_model* made = nullptr;
    return released(mien_model_build(session, in.mesh(), &o, &made, error), made,
                    mien_model_release);
}

/// Models and what is learned from faces.
inline void add_long_trainings(const Inputs& in, std::vector<LongCall>& calls) {
    calls.push_back(
        {"model build, geodesic", true, [&in](mien_session* s, mien_cancel* c, mien_error* e) {
             return build_long_model(in, MIEN_KERNEL_GEODESIC_SE, nullptr, s, c, e);
         }});
    calls.push_back({"model build, surface Matern and trained modes", true,
                     [&in](mien_session* s, mien_cancel* c, mien_error* e) {
                         return build_long_model(in, MIEN_KERNEL_SURFACE_MATERN, Inputs::kDataset,
                                                 s, c, e);
                     }});
    calls.push_back({"expression train", true, [](mien_session* s, mien_cancel* c, mien_error* e) {
                         const auto o = with_cancel(mien_train_options_init, c);
                         mien_expression_model* made = nullptr;
                         return released(
                             mien_expression_model_train(s, Inputs::kDataset, &o, &made, e), made,
                             mien_expression_model_release);
                     }});
    calls.push_back({"blendshapes train", true, [](mien_session* s, mien_cancel* c, mien_error* e) {
                         const auto o = with_cancel(mien_blendshape_options_init, c);
                         mien_blendshape_model* made = nullptr;
                         return released(
                             mien_blendshape_model_train(s, Inputs::kDataset, "grin", &o, &made, e),
                             made, mien_blendshape_model_release);
                     }});
    calls.push_back({"score train", true, [](mien_session* s, mien_cancel* c, mien_error* e) {
                         const auto o = with_cancel(mien_score_options_init, c);
                         std::vector<double> grades;
                         for (int k = 0; k < Inputs::kSubjects * Inputs::kExpressions; ++k)
                             grades.push_back(k % 4);
                         mien_score_model* made = nullptr;
                         return released(mien_score_model_train(s, Inputs::kDataset, grades.data(),
                                                                grades.size(), &o, &made, e),
                                         made, mien_score_model_release);
                     }});
}

/// Registration, measuring, the spectrum.
inline void add_long_analyses(const Inputs& in, std::vector<LongCall>& calls) {
    calls.push_back({"spectral basis", true, [&in](mien_session* s, mien_cancel* c, mien_error* e) {
                         auto o = with_cancel(mien_spectral_basis_options_init, c);
                         o.mode_count = 1000;
                         mien_spectral_basis* made = nullptr;
                         return released(mien_spectral_basis_build(s, in.mesh(), &o, &made, e),
                                         made, mien_spectral_basis_release);
                     }});
    calls.push_back(
        {"register with a search", true, [&in](mien_session* s, mien_cancel* c, mien_error* e) {
             auto o = with_cancel(mien_register_options_init, c);
             o.start = MIEN_START_SEARCH;
             mien_registration* made = nullptr;
             return released(mien_register(s, in.model(), in.scan(), &o, &made, e), made,
                             mien_registration_release);
         }});
    calls.push_back({"curvature", true, [&in](mien_session* s, mien_cancel* c, mien_error* e) {
                         const auto o = with_cancel(mien_measure_options_init, c);
                         mien_measurement* made = nullptr;
                         return released(mien_measure_curvature(s, in.mesh(), 20, 1, &o, &made, e),
                                         made, mien_measurement_release);
                     }});
    calls.push_back(
        {"distance between scans", true, [&in](mien_session* s, mien_cancel* c, mien_error* e) {
             const auto o = with_cancel(mien_measure_options_init, c);
             mien_measurement* made = nullptr;
             return released(mien_measure_surface_distance(s, in.dense(), in.scan(), &o, &made, e),
                             made, mien_measurement_release);
         }});
    calls.push_back({"neutralize", true, [&in](mien_session* s, mien_cancel* c, mien_error* e) {
                         auto o = with_cancel(mien_neutralize_options_init, c);
                         o.uncertainty = 1;
                         mien_neutralization* made = nullptr;
                         return released(
                             mien_neutralize_mesh(s, in.expressions(), in.scan(), &o, &made, e),
                             made, mien_neutralization_release);
                     }});
}

/// Faces of one person, and what was learned from many, on 160 faces.
inline void add_long_studies(const Inputs& in, std::vector<LongCall>& calls) {
    calls.push_back({"model tune", true, [&in](mien_session* s, mien_cancel* c, mien_error* e) {
                         auto o = with_cancel(mien_tune_options_init, c);
                         const double sigmas_mm[] = {20, 40, 80};
                         o.num_modes = 300;
                         o.sigmas_mm = sigmas_mm;
                         o.sigma_count = 3;
                         mien_tuning* made = nullptr;
                         return released(
                             mien_model_tune(s, in.mesh(), Inputs::kDataset, &o, &made, e), made,
                             mien_tuning_release);
                     }});
    calls.push_back(
        {"evaluate neutralization", true, [&in](mien_session* s, mien_cancel* c, mien_error* e) {
             const auto o = with_cancel(mien_evaluate_options_init, c);
             mien_evaluation* made = nullptr;
             return released(
                 mien_evaluate_neutralization(s, in.expressions(), Inputs::kDataset, &o, &made, e),
                 made, mien_evaluation_release);
         }});
    calls.push_back({"expression shard", true, [](mien_session* s, mien_cancel* c, mien_error* e) {
                         const auto o = with_cancel(mien_shard_options_init, c);
                         return mien_expression_shard_create(s, Inputs::kDataset, &o,
                                                             "long_shard.safetensors", e);
                     }});
    calls.push_back(
        {"representation train", true, [](mien_session* s, mien_cancel* c, mien_error* e) {
             const auto o = with_cancel(mien_representation_options_init, c);
             mien_representation* made = nullptr;
             return released(
                 mien_representation_train_with_options(
                     s, Inputs::kDataset, MIEN_FEATURES_DEFORMATION_STANDARDISED, &o, &made, e),
                 made, mien_representation_release);
         }});
    calls.push_back({"series", true, [&in](mien_session* s, mien_cancel* c, mien_error* e) {
                         auto o = with_cancel(mien_series_options_init, c);
                         const std::vector<const mien_mesh*> faces(12, in.scan());
                         mien_series* made = nullptr;
                         return released(mien_neutralize_series(s, in.expressions(), faces.data(),
                                                                12, &o, &made, e),
                                         made, mien_series_release);
                     }});
    calls.push_back(
        {"study of six visits", true, [&in](mien_session* s, mien_cancel* c, mien_error* e) {
             auto o = with_cancel(mien_study_options_init, c);
             std::vector<std::uint32_t> vertices;
             for (std::uint32_t v = 0; v < 1800; ++v) vertices.push_back(v);
             const mien_zone zone = {"half", vertices.data(), vertices.size()};
             o.zones = &zone;
             o.zone_count = 1;
             const char* const stable[] = {"half"};
             o.stable_zones = stable;
             o.stable_count = 1;
             const std::vector<const mien_mesh*> faces(6, in.scan());
             const std::vector<double> ones(6 * 3600, 0.2);
             const mien_array_view sd = {ones.data(), ones.size(), 0, MIEN_DTYPE_F64, 0};
             mien_study* made = nullptr;
             return released(mien_study_create_from_meshes(s, faces.data(), 6, &sd, &sd,
                                                           in.expressions(), &o, &made, e),
                             made, mien_study_release);
         }});
}

/// Two surfaces, with the errors of each vertex.
inline void add_long_measurements(const Inputs& in, std::vector<LongCall>& calls) {
    calls.push_back(
        {"volume with errors", true, [&in](mien_session* s, mien_cancel* c, mien_error* e) {
             auto o = with_cancel(mien_measure_options_init, c);
             const std::vector<double> sd(3600, 0.2);
             o.before_sd = o.after_sd = {sd.data(), sd.size(), 0, MIEN_DTYPE_F64, 0};
             mien_measurement* made = nullptr;
             return released(mien_measure_volume(s, in.mesh(), in.scan(), &o, &made, e), made,
                             mien_measurement_release);
         }});
    calls.push_back(
        {"volume between scans", true, [&in](mien_session* s, mien_cancel* c, mien_error* e) {
             const auto o = with_cancel(mien_measure_options_init, c);
             mien_measurement* made = nullptr;
             return released(
                 mien_measure_scan_volume(s, in.dense(), in.scan(), MIEN_CARRY_VERTEX_NORMAL,
                                          nullptr, &o, nullptr, &made, e),
                 made, mien_measurement_release);
         }});
}

/// Meshes of a scan's size.
inline void add_long_mesh_calls(const Inputs& in, std::vector<LongCall>& calls) {
    calls.push_back({"mesh load", false, [](mien_session* s, mien_cancel*, mien_error* e) {
                         mien_mesh* made = nullptr;
                         return released(mien_mesh_load(s, Inputs::kScan, &made, e), made,
                                         mien_mesh_release);
                     }});
    calls.push_back({"mesh clean", false, [&in](mien_session* s, mien_cancel*, mien_error* e) {
                         mien_mesh* made = nullptr;
                         return released(mien_mesh_clean(s, in.dense(), 10, &made, e), made,
                                         mien_mesh_release);
                     }});
    calls.push_back({"mesh decimate", false, [&in](mien_session* s, mien_cancel*, mien_error* e) {
                         mien_mesh* made = nullptr;
                         return released(mien_mesh_decimate(s, in.dense(), 20000, &made, e), made,
                                         mien_mesh_release);
                     }});
    calls.push_back(
        {"lengths along the skin", false, [&in](mien_session* s, mien_cancel*, mien_error* e) {
             const std::uint32_t last = Inputs::kScanSide * Inputs::kScanSide - 1;
             const std::uint32_t pairs[] = {0, last, 5, last / 2};
             double straight[2], along[2];
             return mien_measure_lengths(s, in.dense(), pairs, 2, straight, along, e);
         }});
    calls.push_back(
        {"quadric hierarchy", false, [&in](mien_session* s, mien_cancel*, mien_error* e) {
             mien_hierarchy* made = nullptr;
             return released(mien_hierarchy_build_quadric(s, in.dense(), 3, 4, &made, e), made,
                             mien_hierarchy_release);
         }});
}

/// `in` must outlive the calls.
inline std::vector<LongCall> long_calls(const Inputs& in) {
    std::vector<LongCall> calls;
    add_long_trainings(in, calls);
    add_long_analyses(in, calls);
    add_long_studies(in, calls);
    add_long_measurements(in, calls);
    add_long_mesh_calls(in, calls);
    return calls;
}

}  // namespace endurance
