// Studies of the C++ face: the visits of one person, from registrations to numbers with errors.
#ifndef MIEN_DETAIL_STUDY_HPP
#define MIEN_DETAIL_STUDY_HPP

#include "expression.hpp"
#include "measure.hpp"
#include "registration.hpp"

namespace mien {

/// The settings of mien_study_options: `c` holds its plain numbers, set to the defaults.
struct StudyOptions {
    StudyOptions() { mien_study_options_init(&c, sizeof c); }
    std::vector<MeasureZone> zones;            ///< empty: those of the registrations' model
    std::vector<std::string> treated, stable;  ///< names of zones
    std::vector<std::int32_t> visits;          ///< of each face; empty: each is one of its own
    Progress progress;
    mien_cancel* cancel = nullptr;
    mien_study_options c;
};

/// Visits of one person; copies share them.
class Study {
  public:
    /// expressions: null measures the faces as they are held.
    Study(const Session& session, const std::vector<Registration>& registrations,
          const ExpressionModel* expressions, const StudyOptions& settings = {}) {
        std::vector<const mien_registration*> handles;
        handles.reserve(registrations.size());
        for (const Registration& fit : registrations) handles.push_back(fit.get());
        make(settings, [&](const mien_study_options* options, mien_study** out, mien_error* error) {
            return mien_study_create(
                session.get(), handles.data(), static_cast<std::uint32_t>(handles.size()),
                expressions == nullptr ? nullptr : expressions->get(), options, out, error);
        });
    }
    /// Faces that were fitted elsewhere; normal_sd_mm and weights: one value per vertex, face by
    /// face, or empty.
    Study(const Session& session, const std::vector<Mesh>& faces,
          const std::vector<double>& normal_sd_mm, const std::vector<double>& weights,
          const ExpressionModel* expressions, const StudyOptions& settings = {}) {
        std::vector<const mien_mesh*> handles;
        handles.reserve(faces.size());
        for (const Mesh& face : faces) handles.push_back(face.get());
        const mien_array_view sd = view_of(normal_sd_mm), seen = view_of(weights);
        make(settings, [&](const mien_study_options* options, mien_study** out, mien_error* error) {
            return mien_study_create_from_meshes(
                session.get(), handles.data(), static_cast<std::uint32_t>(handles.size()),
                normal_sd_mm.empty() ? nullptr : &sd, weights.empty() ? nullptr : &seen,
                expressions == nullptr ? nullptr : expressions->get(), options, out, error);
        });
    }

    std::int32_t visit_count() const {
        std::uint32_t count = 0;
        detail::call(mien_study_get_counts, get(), &count, nullptr);
        return static_cast<std::int32_t>(count);
    }
    std::int32_t zone_count() const {
        std::uint32_t count = 0;
        detail::call(mien_study_get_counts, get(), nullptr, &count);
        return static_cast<std::int32_t>(count);
    }
    std::string zone_name(std::int32_t zone) const { return text(mien_study_get_zone_name, zone); }
    std::string expression(std::int32_t visit) const {
        return text(mien_study_get_expression, visit);
    }
    mien_study_change change(std::int32_t first, std::int32_t second, std::int32_t zone) const {
        mien_study_change out{};
        out.struct_size = sizeof out;
        detail::call(mien_study_get_change, get(), first, second, zone, &out);
        return out;
    }
    mien_zone_alignment alignment(std::int32_t first, std::int32_t second) const {
        mien_zone_alignment out{};
        out.struct_size = sizeof out;
        detail::call(mien_study_get_alignment, get(), first, second, &out);
        return out;
    }
    /// The neutral face of a visit in its own frame.
    Mesh neutral(std::int32_t visit) const { return neutral(visit, visit); }
    /// The same, aligned on another visit.
    Mesh neutral(std::int32_t visit, std::int32_t frame) const {
        mien_mesh* mesh = nullptr;
        detail::call(mien_study_get_mesh, get(), visit, frame, &mesh);
        return Mesh(mesh);
    }
    /// Per vertex, mm: MIEN_STUDY_FIELD_*.
    std::vector<double> field(std::int32_t visit, std::int32_t field) const {
        return values(mien_study_get_field, visit, field);
    }
    /// Per vertex, mm: how far the second neutral face lies outside the first.
    std::vector<double> distances_mm(std::int32_t first, std::int32_t second) const {
        return values(mien_study_get_distances, first, second);
    }
    std::string json() const { return detail::read_text(mien_study_get_json, get()); }
    const mien_study* get() const noexcept { return handle_.get(); }

  private:
    static mien_array_view view_of(const std::vector<double>& values) {
        return {values.data(), values.size(), sizeof(double), MIEN_DTYPE_F64, 0};
    }
    template <typename Function>
    void make(const StudyOptions& settings, Function function) {
        mien_study_options options = settings.c;
        std::vector<mien_zone> zones;
        for (const MeasureZone& zone : settings.zones)
            zones.push_back({zone.name.c_str(), zone.vertices.data(), zone.vertices.size()});
        std::vector<const char*> treated, stable;
        for (const std::string& name : settings.treated) treated.push_back(name.c_str());
        for (const std::string& name : settings.stable) stable.push_back(name.c_str());
        if (!zones.empty()) {
            options.zones = zones.data();
            options.zone_count = zones.size();
        }
        options.treated_zones = treated.data();
        options.treated_count = treated.size();
        options.stable_zones = stable.data();
        options.stable_count = stable.size();
        if (!settings.visits.empty()) {
            options.visits = settings.visits.data();
            options.visit_number_count = settings.visits.size();
        }
        options.cancel = settings.cancel;
        detail::ProgressBridge bridge(settings.progress);
        bridge.install(options);
        mien_study* study = nullptr;
        bridge.call(function, &options, &study);
        handle_ = std::shared_ptr<mien_study>(study, mien_study_release);
    }
    template <typename Function>
    std::string text(Function function, std::int32_t index) const {
        auto read = [&](const mien_study* study, char* dst, std::uint64_t capacity,
                        std::uint64_t* count, mien_error* error) {
            return function(study, index, dst, capacity, count, error);
        };
        return detail::read_text(read, get());
    }
    template <typename Function>
    std::vector<double> values(Function function, std::int32_t a, std::int32_t b) const {
        std::uint64_t count = 0;
        detail::call(function, get(), a, b, nullptr, std::uint64_t{0}, &count);
        std::vector<double> values(static_cast<std::size_t>(count));
        detail::call(function, get(), a, b, values.data(), count, &count);
        return values;
    }
    std::shared_ptr<mien_study> handle_;
};

}  // namespace mien

#endif
