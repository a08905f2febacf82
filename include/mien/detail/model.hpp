// Deformation models of the C++ face.
#ifndef MIEN_DETAIL_MODEL_HPP
#define MIEN_DETAIL_MODEL_HPP

#include "core.hpp"

namespace mien {

struct ModelLandmark {
    std::string name;
    std::uint32_t vertex = 0;
};
struct ModelZone {
    std::string name;
    std::vector<std::uint32_t> vertices;
};

/// Where a landmark of the model was seen, in the frame of the template.
struct LandmarkObservation {
    std::string name;
    Position position{{0, 0, 0}};
    double noise_mm = 1;
};

/// The settings of mien_tune_options.
struct TuneSettings {
    TuneSettings() {
        mien_tune_options defaults;
        mien_tune_options_init(&defaults, sizeof defaults);
        kernel = defaults.kernel;
        scale_mm = defaults.scale_mm;
        nu = defaults.nu;
        rho = defaults.rho;
        levels = defaults.levels;
        num_modes = defaults.num_modes;
        max_subjects = static_cast<int>(defaults.max_subjects);
    }
    std::int32_t kernel;
    std::vector<double> sigmas_mm;
    double scale_mm, nu, rho;
    int levels, num_modes;
    std::vector<std::string> expressions;    ///< empty: all
    int max_subjects;                        ///< 0: all
    std::vector<double> scales_mm;           ///< each with each sigma; empty: scale_mm alone
    std::vector<std::int32_t> level_counts;  ///< each with each of those; empty: levels alone
    Progress progress;
    mien_cancel* cancel = nullptr;
};

/// The settings of mien_model_options; see there for units, ranges and defaults, which they have.
struct ModelSettings {
    ModelSettings() {
        mien_model_options defaults;
        mien_model_options_init(&defaults, sizeof defaults);
        kernel = defaults.kernel;
        sigma_mm = defaults.sigma_mm;
        scale_mm = defaults.scale_mm;
        nu = defaults.nu;
        levels = defaults.levels;
        num_modes = defaults.num_modes;
        tolerance = defaults.tolerance;
        num_control_points = defaults.num_control_points;
        mirror_symmetric = defaults.mirror_symmetric != 0;
        mirror_correlation = defaults.mirror_correlation;
        heat_time_factor = defaults.heat_time_factor;
        heat_boundary = defaults.heat_boundary;
        pca_modes = defaults.pca_modes;
        pca_variance = defaults.pca_variance;
        pca_all_expressions = defaults.pca_all_expressions != 0;
        pca_align = defaults.pca_align != 0;
    }
    std::int32_t kernel;
    double sigma_mm, scale_mm, nu;
    int levels, num_modes;
    std::vector<mien_kernel> more_kernels;
    double tolerance;
    int num_control_points;
    bool mirror_symmetric;
    double mirror_correlation, heat_time_factor;
    std::int32_t heat_boundary;
    std::string pca_dataset;  ///< empty: none
    int pca_modes;
    double pca_variance;
    bool pca_all_expressions, pca_align;
    std::vector<double> scale_per_vertex;
    std::vector<ModelLandmark> landmarks;
    std::vector<ModelZone> zones;
    Progress progress;
    mien_cancel* cancel = nullptr;
};

/// How a template may move. Immutable; copies share it.
class Model {
  public:
    static Model build(const Session& session, const Mesh& template_mesh,
                       const ModelSettings& settings = {}) {
        std::vector<mien_landmark> landmarks;
        for (const ModelLandmark& landmark : settings.landmarks)
            landmarks.push_back({landmark.name.c_str(), landmark.vertex, 0});
        std::vector<mien_zone> zones;
        for (const ModelZone& zone : settings.zones)
            zones.push_back({zone.name.c_str(), zone.vertices.data(), zone.vertices.size()});
        mien_model_options options;
        mien_model_options_init(&options, sizeof options);
        options.kernel = settings.kernel;
        options.sigma_mm = settings.sigma_mm;
        options.scale_mm = settings.scale_mm;
        options.nu = settings.nu;
        options.levels = settings.levels;
        options.num_modes = settings.num_modes;
        options.kernels = settings.more_kernels.data();
        options.kernel_count = settings.more_kernels.size();
        options.tolerance = settings.tolerance;
        options.num_control_points = settings.num_control_points;
        options.mirror_symmetric = settings.mirror_symmetric ? 1 : 0;
        options.mirror_correlation = settings.mirror_correlation;
        options.heat_time_factor = settings.heat_time_factor;
        options.heat_boundary = settings.heat_boundary;
        options.pca_dataset = settings.pca_dataset.empty() ? nullptr : settings.pca_dataset.c_str();
        options.pca_modes = settings.pca_modes;
        options.pca_variance = settings.pca_variance;
        options.pca_all_expressions = settings.pca_all_expressions ? 1 : 0;
        options.pca_align = settings.pca_align ? 1 : 0;
        if (!settings.scale_per_vertex.empty())
            options.scale_per_vertex = {settings.scale_per_vertex.data(),
                                        settings.scale_per_vertex.size(), 0, MIEN_DTYPE_F64, 0};
        options.landmarks = landmarks.data();
        options.landmark_count = landmarks.size();
        options.zones = zones.data();
        options.zone_count = zones.size();
        options.cancel = settings.cancel;
        detail::ProgressBridge bridge(settings.progress);
        bridge.install(options);
        mien_model* model = nullptr;
        bridge.call(mien_model_build, session.get(), template_mesh.get(), &options, &model);
        return Model(model);
    }
    Model(const Session& session, const std::string& path) {
        mien_model* model = nullptr;
        detail::call(mien_model_load, session.get(), path.c_str(), &model);
        handle_ = std::shared_ptr<mien_model>(model, mien_model_release);
    }
    /// Without checking the hash and the values: for files that the host trusts.
    static Model load_trusted(const Session& session, const std::string& path) {
        mien_model* model = nullptr;
        detail::call(mien_model_load_trusted, session.get(), path.c_str(), &model);
        return Model(model);
    }
    /// From the bytes of a model file, which are copied.
    static Model load_memory(const Session& session, const void* data, std::size_t size) {
        mien_model* model = nullptr;
        detail::call(mien_model_load_memory, session.get(), data, size, &model);
        return Model(model);
    }
    /// Takes over one reference.
    explicit Model(mien_model* owned) : handle_(owned, mien_model_release) {}

    void save(const Session& session, const std::string& path) const {
        detail::call(mien_model_save, session.get(), get(), path.c_str());
    }
    Mesh mesh() const { return Mesh::share(mien_model_mesh(get())); }
    std::size_t vertex_count() const { return count(0); }
    std::size_t scalar_modes() const { return count(1); }
    std::size_t vector_modes() const { return count(2); }
    std::string json() const { return detail::read_text(mien_model_get_json, get()); }
    /// Random face `index` of `seed`; strength 0 is the mean.
    Mesh sample(const Session& session, std::uint64_t seed, std::uint64_t index,
                double strength = 1) const {
        mien_mesh* mesh = nullptr;
        detail::call(mien_model_sample, session.get(), get(), seed, index, strength, &mesh);
        return Mesh(mesh);
    }
    /// The posterior once landmarks were seen.
    Model condition(const Session& session, const std::vector<LandmarkObservation>& seen) const {
        std::vector<mien_landmark_observation> observations;
        observations.reserve(seen.size());
        for (const LandmarkObservation& one : seen)
            observations.push_back({one.name.c_str(),
                                    0,
                                    0,
                                    {one.position[0], one.position[1], one.position[2]},
                                    one.noise_mm});
        mien_model* model = nullptr;
        detail::call(mien_model_condition, session.get(), get(), observations.data(),
                     std::uint64_t{observations.size()}, &model);
        return Model(model);
    }
    /// Prior variance per vertex and coordinate, mm^2.
    std::vector<Position> variance() const {
        std::vector<Position> out(vertex_count());
        std::uint64_t rows = 0;
        detail::call(mien_model_get_variance, get(), out.front().data(), std::uint64_t{out.size()},
                     &rows);
        return out;
    }
    const mien_model* get() const noexcept { return handle_.get(); }

  private:
    std::size_t count(int which) const {
        std::uint64_t counts[3] = {0, 0, 0};
        detail::call(mien_model_get_counts, get(), &counts[0], &counts[1], &counts[2]);
        return static_cast<std::size_t>(counts[which]);
    }
    std::shared_ptr<mien_model> handle_;
};

/// Residual against sigma on faces of known correspondence, as JSON text.
inline std::string tune_kernel(const Session& session, const Mesh& template_mesh,
                               const std::string& dataset, const TuneSettings& settings) {
    std::vector<const char*> expressions;
    for (const std::string& name : settings.expressions) expressions.push_back(name.c_str());
    mien_tune_options options;
    mien_tune_options_init(&options, sizeof options);
    options.kernel = settings.kernel;
    options.sigmas_mm = settings.sigmas_mm.data();
    options.sigma_count = settings.sigmas_mm.size();
    options.scale_mm = settings.scale_mm;
    options.nu = settings.nu;
    options.rho = settings.rho;
    options.levels = settings.levels;
    options.num_modes = settings.num_modes;
    options.expressions = expressions.data();
    options.expression_count = static_cast<std::uint32_t>(expressions.size());
    options.max_subjects = settings.max_subjects;
    options.scales_mm = settings.scales_mm.data();
    options.scale_count = settings.scales_mm.size();
    options.level_counts = settings.level_counts.data();
    options.level_count = settings.level_counts.size();
    options.cancel = settings.cancel;
    detail::ProgressBridge bridge(settings.progress);
    bridge.install(options);
    mien_tuning* tuning = nullptr;
    bridge.call(mien_model_tune, session.get(), template_mesh.get(), dataset.c_str(), &options,
                &tuning);
    const detail::Handle<mien_tuning, mien_tuning_release> owner(tuning);
    return detail::read_text(mien_tuning_get_json, static_cast<const mien_tuning*>(tuning));
}

}  // namespace mien

#endif
