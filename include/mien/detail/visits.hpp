// Visits of the C++ face: one person's faces over time.
#ifndef MIEN_DETAIL_VISITS_HPP
#define MIEN_DETAIL_VISITS_HPP

#include "expression.hpp"
#include "measure.hpp"

namespace mien {

/// mien_visits_options with its defaults.
struct VisitsOptions : mien_visits_options {
    VisitsOptions() { mien_visits_options_init(this, sizeof(mien_visits_options)); }
    /// `values`, one per vertex, face by face, must live until the call returns.
    void set_weights(const std::vector<double>& values) {
        weights = {values.data(), values.size(), sizeof(double), MIEN_DTYPE_F64, 0};
    }
    /// `vertices` must live until the call returns.
    void set_treated(const std::vector<std::uint32_t>& vertices) {
        treated_vertices = vertices.data();
        treated_count = vertices.size();
    }
};

/// What expressions amount to in a volume, mL.
struct RemovedVolume {
    double removed_ml = 0, sd_ml = 0;
};

/// Several visits of one person, without their expressions.
class Visits {
  public:
    Visits(const Session& session, const ExpressionModel& model, const std::vector<Mesh>& faces,
           VisitsOptions options = {}, const Progress& progress = {}) {
        std::vector<const mien_mesh*> handles;
        handles.reserve(faces.size());
        for (const Mesh& face : faces) handles.push_back(face.get());
        detail::ProgressBridge bridge(progress);
        bridge.install(options);
        mien_visits* visits = nullptr;
        bridge.call(mien_neutralize_visits, session.get(), model.get(), handles.data(),
                    static_cast<std::uint32_t>(handles.size()), &options, &visits);
        handle_.reset(visits);
    }
    /// The neutral face of one visit, in the frame of its face.
    Mesh neutral(std::int32_t index) const {
        mien_mesh* mesh = nullptr;
        detail::call(mien_visits_get_mesh, get(), index, &mesh);
        return Mesh(mesh);
    }
    std::string expression(std::int32_t index) const {
        auto read = [index](const mien_visits* visits, char* dst, std::uint64_t capacity,
                            std::uint64_t* count, mien_error* error) {
            return mien_visits_get_expression(visits, index, dst, capacity, count, error);
        };
        return detail::read_text(read, get());
    }
    RemovedVolume removed_volume(std::int32_t first, std::int32_t second,
                                 const MeasureZone& zone) const {
        const mien_zone view{zone.name.c_str(), zone.vertices.data(), zone.vertices.size()};
        RemovedVolume removed;
        detail::call(mien_visits_get_removed_volume, get(), first, second, &view,
                     &removed.removed_ml, &removed.sd_ml);
        return removed;
    }
    mien_visits* get() const noexcept { return handle_.get(); }

  private:
    detail::Handle<mien_visits, mien_visits_release> handle_;
};

}  // namespace mien

#endif
