// Anthropometry, norms and asymmetry of the C++ face.
#ifndef MIEN_DETAIL_ANTHROPOMETRY_HPP
#define MIEN_DETAIL_ANTHROPOMETRY_HPP

#include "landmarks.hpp"
#include "measure.hpp"

namespace mien {

/// The landmarks of a template and those of its profile (glabella, nasion, ...) beside them.
inline Landmarks with_profile(const Landmarks& landmarks, const Mesh& template_mesh) {
    mien_landmarks* all = nullptr;
    detail::call(mien_landmarks_add_profile, landmarks.get(), template_mesh.get(), &all);
    return Landmarks(all);
}

/// Mean and deviation of each measurement over a dataset's people; copies share them.
class Norms {
  public:
    /// Over the neutral faces of a dataset.
    Norms(const Session& session, const std::string& dataset_path, const Landmarks& landmarks,
          const Progress& progress = {}) {
        mien_anthropometry_options options;
        mien_anthropometry_options_init(&options, sizeof options);
        detail::ProgressBridge bridge(progress);
        bridge.install(options);
        mien_norms* norms = nullptr;
        bridge.call(mien_norms_create, session.get(), dataset_path.c_str(), landmarks.get(),
                    &options, &norms);
        handle_ = std::shared_ptr<mien_norms>(norms, mien_norms_release);
    }
    /// What save() wrote.
    Norms(const Session& session, const std::string& path) {
        mien_norms* norms = nullptr;
        detail::call(mien_norms_load, session.get(), path.c_str(), &norms);
        handle_ = std::shared_ptr<mien_norms>(norms, mien_norms_release);
    }
    void save(const Session& session, const std::string& path) const {
        detail::call(mien_norms_save, session.get(), get(), path.c_str());
    }
    std::string json() const { return detail::read_text(mien_norms_get_json, get()); }
    const mien_norms* get() const noexcept { return handle_.get(); }

  private:
    std::shared_ptr<mien_norms> handle_;
};

/// The settings of mien_anthropometry_options; an empty vector is "not known".
struct AnthropometryOptions {
    AnthropometryOptions() {
        mien_anthropometry_options defaults;
        mien_anthropometry_options_init(&defaults, sizeof defaults);
        slide_correlation_mm = defaults.slide_correlation_mm;
        normal_correlation_mm = defaults.normal_correlation_mm;
    }
    std::vector<double> place_sd_mm, normal_sd_mm;
    double slide_correlation_mm, normal_correlation_mm;
    const Norms* norms = nullptr;
    mien_cancel* cancel = nullptr;
};

/// The measurements of one face; copies share them.
class Anthropometry {
  public:
    Anthropometry(const Session& session, const Mesh& face, const Landmarks& landmarks,
                  const AnthropometryOptions& settings = {}) {
        mien_anthropometry_options options;
        mien_anthropometry_options_init(&options, sizeof options);
        const auto view = [](const std::vector<double>& values) {
            return mien_array_view{values.data(), values.size(), 0, MIEN_DTYPE_F64, 0};
        };
        if (!settings.place_sd_mm.empty()) options.place_sd = view(settings.place_sd_mm);
        if (!settings.normal_sd_mm.empty()) options.normal_sd = view(settings.normal_sd_mm);
        options.slide_correlation_mm = settings.slide_correlation_mm;
        options.normal_correlation_mm = settings.normal_correlation_mm;
        options.norms = settings.norms != nullptr ? settings.norms->get() : nullptr;
        options.cancel = settings.cancel;
        mien_anthropometry* list = nullptr;
        detail::call(mien_measure_anthropometry, session.get(), face.get(), landmarks.get(),
                     &options, &list);
        handle_ = std::shared_ptr<mien_anthropometry>(list, mien_anthropometry_release);
    }
    std::size_t size() const {
        std::uint64_t count = 0;
        detail::call(mien_anthropometry_get_counts, get(), &count, nullptr);
        return static_cast<std::size_t>(count);
    }
    /// How many have a value.
    std::size_t known_count() const {
        std::uint64_t known = 0;
        detail::call(mien_anthropometry_get_counts, get(), nullptr, &known);
        return static_cast<std::size_t>(known);
    }
    std::string name(std::size_t index) const { return text(mien_anthropometry_get_name, index); }
    /// Why it has no value; empty when it has one.
    std::string reason(std::size_t index) const {
        return text(mien_anthropometry_get_reason, index);
    }
    mien_anthropometric_value operator[](std::size_t index) const {
        mien_anthropometric_value value{};
        value.struct_size = sizeof value;
        detail::call(mien_anthropometry_get_value, get(), static_cast<std::uint64_t>(index),
                     &value);
        return value;
    }
    std::string json() const { return detail::read_text(mien_anthropometry_get_json, get()); }
    const mien_anthropometry* get() const noexcept { return handle_.get(); }

  private:
    template <typename Function>
    std::string text(Function function, std::size_t index) const {
        const auto number = static_cast<std::uint64_t>(index);
        return detail::read_text(
            [=](const mien_anthropometry* list, char* dst, std::uint64_t capacity,
                std::uint64_t* count,
                mien_error* error) { return function(list, number, dst, capacity, count, error); },
            get());
    }
    std::shared_ptr<mien_anthropometry> handle_;
};

/// The settings of mien_asymmetry_options; an empty vector is "not known".
struct AsymmetrySettings {
    std::vector<MeasureZone> zones;
    std::vector<double> normal_sd_mm;
    std::int32_t plane = MIEN_MIRROR_BY_SURFACE;
    const Landmarks* landmarks = nullptr;
    double correlation_length_mm = MeasureOptions().correlation_length_mm;
    Progress progress;
    mien_cancel* cancel = nullptr;
};

/// Left against right, as a measurement with its mirror plane.
class Asymmetry {
  public:
    Asymmetry(const Session& session, const Mesh& face, const Mesh& template_mesh,
              const AsymmetrySettings& settings = {}) {
        mien_asymmetry_options options;
        mien_asymmetry_options_init(&options, sizeof options);
        std::vector<mien_zone> zones;
        for (const MeasureZone& zone : settings.zones)
            zones.push_back({zone.name.c_str(), zone.vertices.data(), zone.vertices.size()});
        options.plane = settings.plane;
        options.zones = zones.data();
        options.zone_count = zones.size();
        options.landmarks = settings.landmarks != nullptr ? settings.landmarks->get() : nullptr;
        if (!settings.normal_sd_mm.empty())
            options.normal_sd = {settings.normal_sd_mm.data(), settings.normal_sd_mm.size(), 0,
                                 MIEN_DTYPE_F64, 0};
        options.correlation_length_mm = settings.correlation_length_mm;
        options.cancel = settings.cancel;
        detail::ProgressBridge bridge(settings.progress);
        bridge.install(options);
        mien_measurement* made = nullptr;
        bridge.call(mien_measure_asymmetry, session.get(), face.get(), template_mesh.get(),
                    &options, &made);
        measurement_ = Measurement(made);
    }
    /// Volumes, distances and fields; zones without their side.
    const Measurement& measurement() const noexcept { return measurement_; }
    mien_mirror_plane plane() const {
        mien_mirror_plane out{};
        out.struct_size = sizeof out;
        detail::call(mien_measurement_get_mirror_plane, measurement_.get(), &out);
        return out;
    }

  private:
    Measurement measurement_;
};

}  // namespace mien

#endif
