// Bands, metrics, representations, hierarchies and blendshapes of the C++ face.
#ifndef MIEN_DETAIL_SPECTRAL_HPP
#define MIEN_DETAIL_SPECTRAL_HPP

#include <stdexcept>

#include "core.hpp"

namespace mien {

namespace detail {

/// Calls f(arguments..., &mesh, error) and owns the mesh.
template <typename Function, typename... Arguments>
Mesh make_mesh(Function function, Arguments&&... arguments) {
    mien_mesh* mesh = nullptr;
    call(function, std::forward<Arguments>(arguments)..., &mesh);
    return Mesh(mesh);
}

}  // namespace detail

struct SpectralBasisOptions {
    std::uint32_t mode_count = 500;
    std::int32_t mass = MIEN_MASS_MIXED_VORONOI;
    std::int32_t cotangents = MIEN_COTANGENTS_INTRINSIC_DELAUNAY;
    Progress progress;
    mien_cancel* cancel = nullptr;
};

/// Frequency bands of faces in one topology; copies share it.
class SpectralBasis {
  public:
    static SpectralBasis build(const Session& session, const Mesh& mean,
                               const SpectralBasisOptions& settings = {}) {
        mien_spectral_basis_options options;
        mien_spectral_basis_options_init(&options, sizeof options);
        options.mode_count = settings.mode_count;
        options.mass = settings.mass;
        options.cotangents = settings.cotangents;
        options.cancel = settings.cancel;
        detail::ProgressBridge bridge(settings.progress);
        bridge.install(options);
        mien_spectral_basis* basis = nullptr;
        bridge.call(mien_spectral_basis_build, session.get(), mean.get(), &options, &basis);
        return SpectralBasis(basis);
    }
    static SpectralBasis load(const Session& session, const std::string& path) {
        mien_spectral_basis* basis = nullptr;
        detail::call(mien_spectral_basis_load, session.get(), path.c_str(), &basis);
        return SpectralBasis(basis);
    }
    void save(const Session& session, const std::string& path) const {
        detail::call(mien_spectral_basis_save, session.get(), get(), path.c_str());
    }
    std::uint64_t mode_count() const {
        std::uint64_t modes = 0;
        detail::call(mien_spectral_basis_get_counts, get(), nullptr, &modes);
        return modes;
    }
    std::vector<double> eigenvalues() const {
        std::vector<double> values(static_cast<std::size_t>(mode_count()));
        std::uint64_t count = 0;
        detail::call(mien_spectral_basis_get_eigenvalues, get(), values.data(),
                     std::uint64_t{values.size()}, &count);
        return values;
    }
    /// The eigenvector of a mode, one value per vertex.
    std::vector<double> vector(std::uint64_t mode) const {
        return read_vertex_values([mode](const mien_spectral_basis* basis, double* dst,
                                         std::uint64_t capacity, std::uint64_t* count,
                                         mien_error* error) {
            return mien_spectral_basis_get_vector(basis, mode, dst, capacity, count, error);
        });
    }
    /// The diagonal of the mass matrix, mm^2 per vertex.
    std::vector<double> mass() const { return read_vertex_values(mien_spectral_basis_get_mass); }
    Mesh mean() const { return detail::make_mesh(mien_spectral_basis_get_mean, get()); }
    /// The first spectral coefficients of a face, x y z per mode.
    std::vector<Position> project(const Session& session, const Mesh& face,
                                  std::uint64_t modes) const {
        std::uint64_t count = 0;
        detail::call(mien_spectral_project, session.get(), get(), face.get(), modes, nullptr,
                     std::uint64_t{0}, &count);
        std::vector<Position> rows(static_cast<std::size_t>(count));
        if (count != 0)
            detail::call(mien_spectral_project, session.get(), get(), face.get(), modes,
                         rows.front().data(), count, &count);
        return rows;
    }
    /// The face of these coefficients, which begin at mode `first`.
    Mesh synthesize(const Session& session, const std::vector<Position>& coefficients,
                    std::uint64_t first = 0) const {
        return detail::make_mesh(mien_spectral_synthesize, session.get(), get(),
                                 coefficients.empty() ? nullptr : coefficients.front().data(),
                                 std::uint64_t{coefficients.size()}, first);
    }
    Mesh low(const Session& session, const Mesh& face, std::uint64_t k) const {
        mien_mesh* mesh = nullptr;
        detail::call(mien_spectral_split, session.get(), get(), face.get(), k, &mesh, nullptr);
        return Mesh(mesh);
    }
    Mesh high(const Session& session, const Mesh& face, std::uint64_t k) const {
        mien_mesh* mesh = nullptr;
        detail::call(mien_spectral_split, session.get(), get(), face.get(), k, nullptr, &mesh);
        return Mesh(mesh);
    }
    Mesh assemble(const Session& session, const Mesh& low, const Mesh& high,
                  std::uint64_t k) const {
        return detail::make_mesh(mien_spectral_assemble, session.get(), get(), low.get(),
                                 high.get(), k);
    }
    Mesh edit(const Session& session, const Mesh& face, const std::vector<std::uint64_t>& limits,
              const std::vector<double>& gains) const {
        check_bands(limits, gains);
        return detail::make_mesh(mien_spectral_edit, session.get(), get(), face.get(),
                                 limits.data(), std::uint64_t{limits.size()}, gains.data());
    }
    Mesh mix(const Session& session, const Mesh& first, const Mesh& second,
             const std::vector<std::uint64_t>& limits, const std::vector<double>& weights) const {
        check_bands(limits, weights);
        return detail::make_mesh(mien_spectral_mix, session.get(), get(), first.get(), second.get(),
                                 limits.data(), std::uint64_t{limits.size()}, weights.data());
    }
    const mien_spectral_basis* get() const noexcept { return handle_.get(); }

  private:
    explicit SpectralBasis(mien_spectral_basis* basis)
        : handle_(basis, mien_spectral_basis_release) {}
    template <typename Function>
    std::vector<double> read_vertex_values(Function function) const {
        std::uint64_t count = 0;
        detail::call(function, get(), nullptr, std::uint64_t{0}, &count);
        std::vector<double> values(static_cast<std::size_t>(count));
        detail::call(function, get(), values.data(), count, &count);
        return values;
    }
    static void check_bands(const std::vector<std::uint64_t>& limits,
                            const std::vector<double>& values) {
        if (values.size() != limits.size() + 1)
            throw std::invalid_argument(
                "one value more than limits is needed: the last band is open");
    }
    std::shared_ptr<mien_spectral_basis> handle_;
};

/// MIEN_METRIC_...
inline double metric(const Session& session, std::int32_t kind, const Mesh& reference,
                     const Mesh& other) {
    double value = 0;
    detail::call(mien_metric, session.get(), kind, reference.get(), other.get(), &value);
    return value;
}

/// Where a metric comes from: one value per vertex of the reference.
inline std::vector<double> metric_field(const Session& session, std::int32_t kind,
                                        const Mesh& reference, const Mesh& other) {
    std::vector<double> field(reference.vertex_count());
    std::uint64_t count = 0;
    detail::call(mien_metric_field, session.get(), kind, reference.get(), other.get(), field.data(),
                 std::uint64_t{field.size()}, &count);
    return field;
}

/// Local roughness of one mesh, rad per vertex.
inline std::vector<double> roughness(const Session& session, const Mesh& mesh) {
    std::vector<double> field(mesh.vertex_count());
    std::uint64_t count = 0;
    detail::call(mien_metric_roughness, session.get(), mesh.get(), field.data(),
                 std::uint64_t{field.size()}, &count);
    return field;
}

/// Faces as numbers for learning, and back; copies share it.
class Representation {
  public:
    using Motion = std::array<double, 12>;
    static Representation train(const Session& session, const std::string& dataset_path,
                                std::int32_t kind, bool neutral_only = false,
                                const Progress& progress = {}, mien_cancel* cancel = nullptr) {
        mien_representation_options options;
        mien_representation_options_init(&options, sizeof options);
        options.neutral_only = neutral_only ? 1 : 0;
        options.cancel = cancel;
        detail::ProgressBridge bridge(progress);
        bridge.install(options);
        mien_representation* representation = nullptr;
        bridge.call(mien_representation_train_with_options, session.get(), dataset_path.c_str(),
                    kind, &options, &representation);
        return Representation(representation);
    }
    static Representation load(const Session& session, const std::string& path) {
        mien_representation* representation = nullptr;
        detail::call(mien_representation_load, session.get(), path.c_str(), &representation);
        return Representation(representation);
    }
    void save(const Session& session, const std::string& path) const {
        detail::call(mien_representation_save, session.get(), get(), path.c_str());
    }
    std::size_t channel_count() const {
        std::uint64_t channels = 0;
        detail::call(mien_representation_get_counts, get(), nullptr, &channels);
        return static_cast<std::size_t>(channels);
    }
    /// #V x channel_count(), row by row.
    std::vector<double> encode(const Session& session, const Mesh& face,
                               Motion* motion = nullptr) const {
        std::uint64_t vertices = 0, channels = 0, count = 0;
        detail::call(mien_representation_get_counts, get(), &vertices, &channels);
        std::vector<double> features(static_cast<std::size_t>(vertices * channels));
        detail::call(mien_representation_encode, session.get(), get(), face.get(),
                     motion != nullptr ? motion->data() : nullptr, features.data(), vertices,
                     &count);
        return features;
    }
    Mesh decode(const Session& session, const std::vector<double>& features,
                const Motion* motion = nullptr) const {
        const std::uint64_t rows = features.size() / channel_count();
        return detail::make_mesh(mien_representation_decode, session.get(), get(), features.data(),
                                 rows, motion != nullptr ? motion->data() : nullptr);
    }
    const mien_representation* get() const noexcept { return handle_.get(); }

  private:
    explicit Representation(mien_representation* owned)
        : handle_(owned, mien_representation_release) {}
    std::shared_ptr<mien_representation> handle_;
};

/// Levels of a template; copies share it.
class Hierarchy {
  public:
    static Hierarchy quadric(const Session& session, const Mesh& mesh, std::uint32_t levels,
                             double factor) {
        mien_hierarchy* hierarchy = nullptr;
        detail::call(mien_hierarchy_build_quadric, session.get(), mesh.get(), levels, factor,
                     &hierarchy);
        return Hierarchy(hierarchy);
    }
    static Hierarchy connectivity(const Session& session, const Mesh& mesh, std::uint32_t levels,
                                  std::uint32_t stride, std::uint32_t radius) {
        mien_hierarchy* hierarchy = nullptr;
        detail::call(mien_hierarchy_build_connectivity, session.get(), mesh.get(), levels, stride,
                     radius, &hierarchy);
        return Hierarchy(hierarchy);
    }
    static Hierarchy load(const Session& session, const std::string& path) {
        mien_hierarchy* hierarchy = nullptr;
        detail::call(mien_hierarchy_load, session.get(), path.c_str(), &hierarchy);
        return Hierarchy(hierarchy);
    }
    void save(const Session& session, const std::string& path) const {
        detail::call(mien_hierarchy_save, session.get(), get(), path.c_str());
    }
    std::uint32_t level_count() const {
        std::uint32_t count = 0;
        detail::call(mien_hierarchy_get_level_count, get(), &count);
        return count;
    }
    Mesh level(std::uint32_t level) const {
        return detail::make_mesh(mien_hierarchy_get_level, get(), level);
    }
    /// Values on vertices, channels a row, through MIEN_MAP_DOWN or MIEN_MAP_UP of a level.
    std::vector<double> apply(std::uint32_t level, std::int32_t direction,
                              const std::vector<double>& values, std::uint64_t channels) const {
        std::uint64_t count = 0;
        const std::uint64_t rows = channels == 0 ? 0 : values.size() / channels;
        detail::call(mien_hierarchy_apply, get(), level, direction, values.data(), rows, channels,
                     nullptr, std::uint64_t{0}, &count);
        std::vector<double> result(static_cast<std::size_t>(count * channels));
        detail::call(mien_hierarchy_apply, get(), level, direction, values.data(), rows, channels,
                     result.data(), count, &count);
        return result;
    }
    /// A map as a sparse matrix, entry by entry.
    struct Map {
        std::vector<std::uint32_t> rows, columns;
        std::vector<double> values;
        std::uint64_t row_count = 0, column_count = 0;
    };
    Map map(std::uint32_t level, std::int32_t direction) const {
        Map out;
        std::uint64_t count = 0;
        detail::call(mien_hierarchy_get_map, get(), level, direction, nullptr, nullptr, nullptr,
                     std::uint64_t{0}, &count, &out.row_count, &out.column_count);
        out.rows.resize(static_cast<std::size_t>(count));
        out.columns.resize(out.rows.size());
        out.values.resize(out.rows.size());
        detail::call(mien_hierarchy_get_map, get(), level, direction, out.rows.data(),
                     out.columns.data(), out.values.data(), count, &count, nullptr, nullptr);
        return out;
    }
    const mien_hierarchy* get() const noexcept { return handle_.get(); }

  private:
    explicit Hierarchy(mien_hierarchy* owned) : handle_(owned, mien_hierarchy_release) {}
    std::shared_ptr<mien_hierarchy> handle_;
};

inline Mesh transfer_expression(const Session& session, const Mesh& source_neutral,
                                const Mesh& source_expression, const Mesh& target_neutral) {
    return detail::make_mesh(mien_transfer_expression, session.get(), source_neutral.get(),
                             source_expression.get(), target_neutral.get());
}

struct BlendshapeOptions {
    double ridge = 0.0;  ///< 0: by leave-one-out error
    Progress progress;
    mien_cancel* cancel = nullptr;
};

/// Predicts one expression from a neutral face; copies share it.
class BlendshapeModel {
  public:
    static BlendshapeModel train(const Session& session, const std::string& dataset_path,
                                 const std::string& expression,
                                 const BlendshapeOptions& settings = {}) {
        detail::ProgressBridge bridge(settings.progress);
        mien_blendshape_options options = options_of(settings, bridge);
        mien_blendshape_model* model = nullptr;
        bridge.call(mien_blendshape_model_train, session.get(), dataset_path.c_str(),
                    expression.c_str(), &options, &model);
        return BlendshapeModel(model);
    }
    static BlendshapeModel load(const Session& session, const std::string& path) {
        mien_blendshape_model* model = nullptr;
        detail::call(mien_blendshape_model_load, session.get(), path.c_str(), &model);
        return BlendshapeModel(model);
    }
    void save(const Session& session, const std::string& path) const {
        detail::call(mien_blendshape_model_save, session.get(), get(), path.c_str());
    }
    Mesh mean() const { return detail::make_mesh(mien_blendshape_model_get_mean, get()); }
    /// Without a basis: k = 0 the deformations' prediction, else the coordinates'.
    Mesh predict(const Session& session, const Mesh& neutral, const SpectralBasis* basis,
                 std::uint64_t k) const {
        return detail::make_mesh(mien_blendshape_model_predict, session.get(), get(),
                                 basis != nullptr ? basis->get() : nullptr, k, neutral.get());
    }
    std::vector<mien_band_choice> search(const Session& session, const SpectralBasis& basis,
                                         const std::string& dataset_path,
                                         const std::string& expression,
                                         const std::vector<std::uint64_t>& candidates,
                                         const BlendshapeOptions& settings = {}) const {
        detail::ProgressBridge bridge(settings.progress);
        mien_blendshape_options options = options_of(settings, bridge);
        std::vector<mien_band_choice> choices(candidates.size());
        bridge.call(mien_blendshape_model_search, session.get(), get(), basis.get(),
                    dataset_path.c_str(), expression.c_str(), candidates.data(),
                    static_cast<std::uint32_t>(candidates.size()), &options, choices.data());
        return choices;
    }
    const mien_blendshape_model* get() const noexcept { return handle_.get(); }

  private:
    explicit BlendshapeModel(mien_blendshape_model* owned)
        : handle_(owned, mien_blendshape_model_release) {}
    static mien_blendshape_options options_of(const BlendshapeOptions& settings,
                                              detail::ProgressBridge& bridge) {
        mien_blendshape_options options;
        mien_blendshape_options_init(&options, sizeof options);
        options.ridge = settings.ridge;
        options.cancel = settings.cancel;
        bridge.install(options);
        return options;
    }
    std::shared_ptr<mien_blendshape_model> handle_;
};

}  // namespace mien

#endif
