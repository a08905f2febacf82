// Landmark and zone lists of the C++ face.
#ifndef MIEN_DETAIL_LANDMARKS_HPP
#define MIEN_DETAIL_LANDMARKS_HPP

#include "core.hpp"
#include "model.hpp"

namespace mien {

/// One landmark of a list.
struct LandmarkMark {
    std::string name;
    std::int32_t where = MIEN_MARK_NOT_PICKED;  ///< MIEN_MARK_*
    Position position{{0, 0, 0}};
    std::uint32_t vertex = 0;
};

/// Landmarks of a file, of a model or of the host; copies share them.
class Landmarks {
  public:
    Landmarks(const Session& session, const std::string& path) {
        mien_landmarks* landmarks = nullptr;
        detail::call(mien_landmarks_load, session.get(), path.c_str(), &landmarks);
        adopt(landmarks);
    }
    explicit Landmarks(const std::vector<LandmarkMark>& places) {
        std::vector<mien_scan_landmark> list;
        list.reserve(places.size());
        for (const LandmarkMark& one : places)
            list.push_back({one.name.c_str(), {one.position[0], one.position[1], one.position[2]}});
        mien_landmarks* landmarks = nullptr;
        detail::call(mien_landmarks_create, list.data(), std::uint64_t{list.size()}, &landmarks);
        adopt(landmarks);
    }
    /// Names and vertices of a model's template.
    static Landmarks of(const Model& model) {
        mien_landmarks* landmarks = nullptr;
        detail::call(mien_model_get_landmarks, model.get(), &landmarks);
        return Landmarks(landmarks);
    }
    /// Takes over one reference.
    explicit Landmarks(mien_landmarks* owned) { adopt(owned); }

    /// Under the model's own names; what it does not know is left out.
    Landmarks match(const Model& model) const {
        mien_landmarks* landmarks = nullptr;
        detail::call(mien_landmarks_match, get(), model.get(), &landmarks);
        return Landmarks(landmarks);
    }
    /// Vertex numbers as places on a mesh.
    Landmarks on(const Mesh& mesh) const {
        mien_landmarks* landmarks = nullptr;
        detail::call(mien_landmarks_on_mesh, get(), mesh.get(), &landmarks);
        return Landmarks(landmarks);
    }
    void save(const Session& session, const std::string& path) const {
        detail::call(mien_landmarks_save, session.get(), get(), path.c_str());
    }
    std::size_t size() const {
        std::uint64_t count = 0;
        detail::call(mien_landmarks_get_counts, get(), &count, nullptr);
        return static_cast<std::size_t>(count);
    }
    std::size_t picked_count() const {
        std::uint64_t picked = 0;
        detail::call(mien_landmarks_get_counts, get(), nullptr, &picked);
        return static_cast<std::size_t>(picked);
    }
    LandmarkMark operator[](std::size_t index) const {
        LandmarkMark mark;
        const auto number = static_cast<std::uint64_t>(index);
        mark.name = detail::read_text(
            [number](const mien_landmarks* list, char* dst, std::uint64_t capacity,
                     std::uint64_t* count, mien_error* error) {
                return mien_landmarks_get_name(list, number, dst, capacity, count, error);
            },
            get());
        detail::call(mien_landmarks_get_mark, get(), number, &mark.where, mark.position.data(),
                     &mark.vertex);
        return mark;
    }
    std::vector<LandmarkMark> all() const {
        std::vector<LandmarkMark> marks;
        for (std::size_t i = 0; i < size(); ++i) marks.push_back((*this)[i]);
        return marks;
    }
    std::string json() const { return detail::read_text(mien_landmarks_get_json, get()); }
    const mien_landmarks* get() const noexcept { return handle_.get(); }

  private:
    void adopt(mien_landmarks* landmarks) {
        handle_ = std::shared_ptr<mien_landmarks>(landmarks, mien_landmarks_release);
    }
    std::shared_ptr<mien_landmarks> handle_;
};

/// Zones of a file, of a model or of the host; copies share them.
class Zones {
  public:
    Zones(const Session& session, const std::string& path) {
        mien_zones* zones = nullptr;
        detail::call(mien_zones_load, session.get(), path.c_str(), &zones);
        adopt(zones);
    }
    explicit Zones(const std::vector<ModelZone>& given) {
        std::vector<mien_zone> list;
        list.reserve(given.size());
        for (const ModelZone& zone : given)
            list.push_back({zone.name.c_str(), zone.vertices.data(), zone.vertices.size()});
        mien_zones* zones = nullptr;
        detail::call(mien_zones_create, list.data(), std::uint64_t{list.size()}, &zones);
        adopt(zones);
    }
    static Zones of(const Model& model) {
        mien_zones* zones = nullptr;
        detail::call(mien_model_get_zones, model.get(), &zones);
        return Zones(zones);
    }
    /// Takes over one reference.
    explicit Zones(mien_zones* owned) { adopt(owned); }

    void save(const Session& session, const std::string& path) const {
        detail::call(mien_zones_save, session.get(), get(), path.c_str());
    }
    std::size_t size() const {
        std::uint64_t count = 0;
        detail::call(mien_zones_get_count, get(), &count);
        return static_cast<std::size_t>(count);
    }
    ModelZone operator[](std::size_t index) const {
        ModelZone zone;
        const auto number = static_cast<std::uint64_t>(index);
        zone.name = detail::read_text(
            [number](const mien_zones* list, char* dst, std::uint64_t capacity,
                     std::uint64_t* count, mien_error* error) {
                return mien_zones_get_name(list, number, dst, capacity, count, error);
            },
            get());
        std::uint64_t count = 0;
        detail::call(mien_zones_get_vertices, get(), number, nullptr, std::uint64_t{0}, &count);
        zone.vertices.resize(static_cast<std::size_t>(count));
        if (count != 0)
            detail::call(mien_zones_get_vertices, get(), number, zone.vertices.data(), count,
                         &count);
        return zone;
    }
    std::vector<ModelZone> all() const {
        std::vector<ModelZone> zones;
        for (std::size_t i = 0; i < size(); ++i) zones.push_back((*this)[i]);
        return zones;
    }
    const mien_zones* get() const noexcept { return handle_.get(); }

  private:
    void adopt(mien_zones* zones) {
        handle_ = std::shared_ptr<mien_zones>(zones, mien_zones_release);
    }
    std::shared_ptr<mien_zones> handle_;
};

/// What makes a mesh a bad template, as JSON text; see mien_template_check().
inline std::string check_template(const Session& session, const Mesh& template_mesh,
                                  const Landmarks* landmarks, bool mirror) {
    return detail::read_text(
        [&](const mien_mesh* mesh, char* dst, std::uint64_t capacity, std::uint64_t* count,
            mien_error* error) {
            return mien_template_check(session.get(), mesh,
                                       landmarks == nullptr ? nullptr : landmarks->get(),
                                       mirror ? 1 : 0, dst, capacity, count, error);
        },
        template_mesh.get());
}

}  // namespace mien

#endif
