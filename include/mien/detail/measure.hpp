// Volumes, areas and distances of the C++ face.
#ifndef MIEN_DETAIL_MEASURE_HPP
#define MIEN_DETAIL_MEASURE_HPP

#include "core.hpp"

namespace mien {

/// A named vertex set.
struct MeasureZone {
    std::string name;
    std::vector<std::uint32_t> vertices;
};

/// The settings of mien_measure_options; an empty vector is "not given".
struct MeasureOptions {
    MeasureOptions() {
        mien_measure_options defaults;
        mien_measure_options_init(&defaults, sizeof defaults);
        correlation_length_mm = defaults.correlation_length_mm;
    }
    std::vector<MeasureZone> zones;
    std::vector<double> before_sd_mm, after_sd_mm;
    double correlation_length_mm;
    double alignment_rotation_sd_rad = 0.0, alignment_translation_sd_mm = 0.0;
    Position alignment_centre{{0, 0, 0}};
    double common_bias_mm = 0.0;
    double limit_of_detection_ml = 0.0;
    double max_distance_mm = 0.0;
    bool skip_borders = true;
    Progress progress;
    mien_cancel* cancel = nullptr;
};

/// A finished measurement; copies share it.
class Measurement {
  public:
    Measurement() = default;
    /// Takes over one reference.
    explicit Measurement(mien_measurement* owned) : handle_(owned, mien_measurement_release) {}
    static Measurement volume(const Session& session, const Mesh& before, const Mesh& after,
                              const MeasureOptions& options = {}) {
        return make(mien_measure_volume, session, before, after, options);
    }
    static Measurement distance(const Session& session, const Mesh& before, const Mesh& after,
                                const MeasureOptions& options = {}) {
        return make(mien_measure_distance, session, before, after, options);
    }
    static Measurement surface_distance(const Session& session, const Mesh& before,
                                        const Mesh& after, const MeasureOptions& options = {}) {
        return make(mien_measure_surface_distance, session, before, after, options);
    }

    /// Scan to scan; carry: MIEN_CARRY_*. `coverage` receives the share of before's area with a
    /// partner.
    static Measurement scan_volume(const Session& session, const Mesh& before, const Mesh& after,
                                   std::int32_t carry, const Position& direction = {{0, 0, 1}},
                                   const MeasureOptions& options = {}, double* coverage = nullptr) {
        auto function = [&](mien_session* s, const mien_mesh* a, const mien_mesh* b,
                            const mien_measure_options* o, mien_measurement** out,
                            mien_error* error) {
            return mien_measure_scan_volume(s, a, b, carry, direction.data(), o, coverage, out,
                                            error);
        };
        return make(function, session, before, after, options);
    }

    /// Curvatures of one surface; the fields MIEN_FIELD_CURVATURE_*.
    static Measurement curvature(const Session& session, const Mesh& mesh, double radius_mm = 6.0,
                                 bool robust = true, const MeasureOptions& options = {}) {
        auto function = [&](mien_session* s, const mien_mesh* a, const mien_mesh*,
                            const mien_measure_options* o, mien_measurement** out,
                            mien_error* error) {
            return mien_measure_curvature(s, a, radius_mm, robust ? 1 : 0, o, out, error);
        };
        return make(function, session, mesh, mesh, options);
    }

    std::size_t zone_count() const {
        std::uint32_t count = 0;
        detail::call(mien_measurement_get_zones, get(), &count, nullptr);
        return count;
    }
    /// zone: 0 .. zone_count() - 1, MIEN_ZONE_WHOLE or MIEN_ZONE_REST.
    mien_zone_volume zone_volume(std::int32_t zone) const {
        mien_zone_volume out{};
        out.struct_size = sizeof out;
        detail::call(mien_measurement_get_volume, get(), zone, &out);
        return out;
    }
    mien_zone_distance zone_distance(std::int32_t zone) const {
        mien_zone_distance out{};
        out.struct_size = sizeof out;
        detail::call(mien_measurement_get_distance, get(), zone, &out);
        return out;
    }
    std::vector<double> field(std::int32_t field) const {
        std::uint64_t count = 0;
        detail::call(mien_measurement_get_field, get(), field, nullptr, std::uint64_t{0}, &count);
        std::vector<double> values(static_cast<std::size_t>(count));
        detail::call(mien_measurement_get_field, get(), field, values.data(), count, &count);
        return values;
    }
    std::string json() const { return detail::read_text(mien_measurement_get_json, get()); }
    const mien_measurement* get() const noexcept { return handle_.get(); }

  private:
    template <typename Function>
    static Measurement make(Function function, const Session& session, const Mesh& before,
                            const Mesh& after, const MeasureOptions& settings) {
        mien_measure_options options;
        mien_measure_options_init(&options, sizeof options);
        std::vector<mien_zone> zones;
        for (const MeasureZone& zone : settings.zones)
            zones.push_back({zone.name.c_str(), zone.vertices.data(), zone.vertices.size()});
        options.zones = zones.data();
        options.zone_count = zones.size();
        if (!settings.before_sd_mm.empty())
            options.before_sd = {settings.before_sd_mm.data(), settings.before_sd_mm.size(), 0,
                                 MIEN_DTYPE_F64, 0};
        if (!settings.after_sd_mm.empty())
            options.after_sd = {settings.after_sd_mm.data(), settings.after_sd_mm.size(), 0,
                                MIEN_DTYPE_F64, 0};
        options.correlation_length_mm = settings.correlation_length_mm;
        options.alignment_rotation_sd_rad = settings.alignment_rotation_sd_rad;
        options.alignment_translation_sd_mm = settings.alignment_translation_sd_mm;
        for (std::size_t k = 0; k < 3; ++k)
            options.alignment_centre[k] = settings.alignment_centre[k];
        options.common_bias_mm = settings.common_bias_mm;
        options.limit_of_detection_ml = settings.limit_of_detection_ml;
        options.max_distance_mm = settings.max_distance_mm;
        options.skip_borders = settings.skip_borders ? 1 : 0;
        options.cancel = settings.cancel;
        detail::ProgressBridge bridge(settings.progress);
        bridge.install(options);
        mien_measurement* measurement = nullptr;
        bridge.call(function, session.get(), before.get(), after.get(), &options, &measurement);
        return Measurement(measurement);
    }
    std::shared_ptr<mien_measurement> handle_;
};

/// Moves a face rigidly onto another by a zone that has not changed; an empty zone means all
/// vertices.
inline Mesh align_on_zone(const Session& session, const Mesh& moving, const Mesh& target,
                          const std::vector<std::uint32_t>& stable,
                          mien_zone_alignment* info = nullptr) {
    const mien_zone zone{"stable", stable.data(), stable.size()};
    mien_zone_alignment local{};
    local.struct_size = sizeof local;
    mien_mesh* mesh = nullptr;
    detail::call(mien_measure_align, session.get(), moving.get(), target.get(),
                 stable.empty() ? nullptr : &zone, &local, &mesh);
    if (info != nullptr) *info = local;
    return Mesh(mesh);
}

/// Straight and along the surface, mm, between pairs of vertices.
struct PlaceLengths {
    std::vector<double> straight_mm, geodesic_mm;
};
inline PlaceLengths lengths_mm(const Session& session, const Mesh& mesh,
                               const std::vector<std::array<std::uint32_t, 2>>& pairs) {
    std::vector<std::uint32_t> flat;
    for (const auto& pair : pairs) flat.insert(flat.end(), pair.begin(), pair.end());
    PlaceLengths lengths{std::vector<double>(pairs.size()), std::vector<double>(pairs.size())};
    detail::call(mien_measure_lengths, session.get(), mesh.get(), flat.data(),
                 static_cast<std::uint64_t>(pairs.size()), lengths.straight_mm.data(),
                 lengths.geodesic_mm.data());
    return lengths;
}

/// mL; an open mesh is an error unless its rims may be closed by fans.
inline double closed_volume_ml(const Session& session, const Mesh& mesh, bool close_rims = false) {
    double volume = 0.0;
    detail::call(mien_measure_closed_volume, session.get(), mesh.get(),
                 std::int32_t{close_rims ? 1 : 0}, &volume);
    return volume;
}

/// mm^2.
inline double area_mm2(const Session& session, const Mesh& mesh) {
    double area = 0.0;
    detail::call(mien_measure_area, session.get(), mesh.get(), nullptr, &area);
    return area;
}
inline double area_mm2(const Session& session, const Mesh& mesh, const MeasureZone& zone) {
    const mien_zone view{zone.name.c_str(), zone.vertices.data(), zone.vertices.size()};
    double area = 0.0;
    detail::call(mien_measure_area, session.get(), mesh.get(), &view, &area);
    return area;
}

}  // namespace mien

#endif
