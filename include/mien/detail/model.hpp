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

/// The settings of mien_model_options; see there for units, ranges and defaults.
struct ModelSettings {
    std::int32_t kernel = MIEN_KERNEL_GEODESIC_SE;
    double sigma_mm = 20, scale_mm = 1, nu = 2;
    int levels = 1, num_modes = 999;
    std::vector<mien_kernel> more_kernels;
    double tolerance = 0;
    int num_control_points = 0;
    bool mirror_symmetric = false;
    double mirror_correlation = 0;
    double heat_time_factor = 1;
    std::int32_t heat_boundary = MIEN_HEAT_NEUMANN;
    std::string pca_dataset;  ///< empty: none
    int pca_modes = 0;
    double pca_variance = 0.98;
    bool pca_all_expressions = false, pca_align = false;
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
    static Model load(const Session& session, const std::string& path) {
        mien_model* model = nullptr;
        detail::call(mien_model_load, session.get(), path.c_str(), &model);
        return Model(model);
    }
    /// Without checking the hash and the values: for files that the host trusts.
    static Model load_trusted(const Session& session, const std::string& path) {
        mien_model* model = nullptr;
        detail::call(mien_model_load_trusted, session.get(), path.c_str(), &model);
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
    const mien_model* get() const noexcept { return handle_.get(); }

  private:
    std::size_t count(int which) const {
        std::uint64_t counts[3] = {0, 0, 0};
        detail::call(mien_model_get_counts, get(), &counts[0], &counts[1], &counts[2]);
        return static_cast<std::size_t>(counts[which]);
    }
    std::shared_ptr<mien_model> handle_;
};

}  // namespace mien

#endif
