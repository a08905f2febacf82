#include "landmarks.hpp"

#include <cmath>
#include <set>

#include "arrays.hpp"
#include "base/json_text.hpp"
#include "guard.hpp"
#include "mesh.hpp"
#include "mesh/zone_file.hpp"
#include "model.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

std::string landmarks_json(const LandmarkFile& file, const NameMatch& match,
                           const std::vector<std::string>& unknown) {
    std::vector<std::string> not_picked;
    for (const Mark& mark : file.marks)
        if (mark.where == Mark::Where::not_picked) not_picked.push_back(mark.name);
    JsonText json;
    json.begin_object()
        .field("format", file.format)
        .field("system", file.system)
        .key("unit_to_mm")
        .number(file.unit_to_mm > 0 ? file.unit_to_mm : std::nan(""))
        .field("count", file.marks.size())
        .field("picked", file.marks.size() - not_picked.size())
        .field("not_picked", not_picked)
        .field("scheme", match.scheme)
        .field("unknown", unknown);
    return json.end_object().take();
}

}  // namespace

mien_landmarks::mien_landmarks(LandmarkFile&& list, const NameMatch& match,
                               const std::vector<std::string>& unknown)
    : Object(kTag), file(std::move(list)), json(landmarks_json(file, match, unknown)) {}

const Mark& mien_landmarks::at(std::uint64_t index) const {
    if (index >= file.marks.size())
        fail(Status::not_found, "index is %llu, the list has %zu landmarks",
             static_cast<unsigned long long>(index), file.marks.size());
    return file.marks[static_cast<std::size_t>(index)];
}

struct mien_zones : Object {
    static constexpr Tag kTag = Tag::zones;
    static constexpr const char* kName = "list of zones";
    explicit mien_zones(std::vector<Zone>&& list) : Object(kTag), zones(std::move(list)) {}
    const std::vector<Zone> zones;
    const Zone& at(std::uint64_t index) const {
        if (index >= zones.size())
            fail(Status::not_found, "index is %llu, the list has %zu zones",
                 static_cast<unsigned long long>(index), zones.size());
        return zones[static_cast<std::size_t>(index)];
    }
};

namespace {

/// Names are looked up and written to files: they must differ and be UTF-8.
template <typename List>
void check_names(const List& list, const char* what) {
    std::set<std::string> seen;
    for (const auto& one : list) {
        if (!is_utf8(one.name))
            fail(Status::invalid_argument, "the name '%s' of a %s is not UTF-8",
                 shown_name(one.name).c_str(), what);
        if (!seen.insert(one.name).second)
            fail(Status::invalid_argument, "the %s '%s' is given twice", what,
                 shown_name(one.name).c_str());
    }
}

LandmarkFile places_of(const mien_scan_landmark* landmarks, std::uint64_t landmark_count) {
    check_array(landmarks, landmark_count, alignof(mien_scan_landmark), kMostNames, "landmarks");
    LandmarkFile file;
    file.format = "array";
    for (std::uint64_t k = 0; k < landmark_count; ++k) {
        Mark mark;
        mark.name = checked_text(landmarks[k].name, "a landmark's name");
        const Vector3 point(landmarks[k].position[0], landmarks[k].position[1],
                            landmarks[k].position[2]);
        if (!point.allFinite())
            fail_at(Status::invalid_argument, static_cast<std::int64_t>(k),
                    "landmark '%s' is not finite; leave out what was not picked",
                    shown_name(mark.name).c_str());
        mark.point = point;
        mark.where = Mark::Where::place;
        file.marks.push_back(std::move(mark));
    }
    check_names(file.marks, "landmark");
    drop_placeholders(file.marks);
    return file;
}

mien_landmarks* matched(const LandmarkFile& given, const DeformationModel& model) {
    const NameMatch match = match_landmark_names(model, given.marks);
    require_known_landmark(model, match, given.marks);
    LandmarkFile file = given;
    file.marks.clear();
    std::vector<std::string> unknown;
    for (std::size_t i = 0; i < given.marks.size(); ++i) {
        if (match.landmark[i] < 0) {
            unknown.push_back(given.marks[i].name);
            continue;
        }
        file.marks.push_back(given.marks[i]);
        file.marks.back().name = model.landmarks[static_cast<std::size_t>(match.landmark[i])].name;
    }
    return new mien_landmarks(std::move(file), match, unknown);
}

LandmarkFile on_mesh(const LandmarkFile& given, const TriMesh& mesh) {
    LandmarkFile file = given;
    for (Mark& mark : file.marks) {
        if (mark.where != Mark::Where::vertex) continue;
        if (mark.vertex >= static_cast<std::uint64_t>(mesh.vertices.rows()))
            fail(Status::mismatch, "the landmark '%s' is vertex %u, the mesh has %lld vertices",
                 shown_name(mark.name).c_str(), mark.vertex,
                 static_cast<long long>(mesh.vertices.rows()));
        mark.point = mesh.vertices.row(mark.vertex).transpose();
        mark.vertex = 0;
        mark.where = Mark::Where::place;
    }
    return file;
}

}  // namespace

extern "C" {

mien_status MIEN_CALL mien_landmarks_load(mien_session* session, const char* path,
                                          mien_landmarks** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return new mien_landmarks(read_landmark_file(checked_text(path, "path"), call.context()));
    });
}

mien_status MIEN_CALL mien_landmarks_create(const mien_scan_landmark* landmarks,
                                            uint64_t landmark_count, mien_landmarks** out,
                                            mien_error* error) {
    return guarded_create(out, error,
                          [&] { return new mien_landmarks(places_of(landmarks, landmark_count)); });
}

mien_status MIEN_CALL mien_model_get_landmarks(const mien_model* model, mien_landmarks** out,
                                               mien_error* error) {
    return guarded_create(out, error, [&] {
        LandmarkFile file;
        file.format = "model";
        for (const Landmark& landmark : checked(model, "model").model->landmarks) {
            Mark mark;
            mark.name = landmark.name;
            mark.vertex = landmark.vertex;
            mark.where = Mark::Where::vertex;
            file.marks.push_back(std::move(mark));
        }
        return new mien_landmarks(std::move(file));
    });
}

mien_status MIEN_CALL mien_landmarks_match(const mien_landmarks* landmarks, const mien_model* model,
                                           mien_landmarks** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_landmarks& given = checked(landmarks, "landmarks");
        return matched(given.file, *checked(model, "model").model);
    });
}

mien_status MIEN_CALL mien_landmarks_on_mesh(const mien_landmarks* landmarks, const mien_mesh* mesh,
                                             mien_landmarks** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_landmarks& given = checked(landmarks, "landmarks");
        return new mien_landmarks(on_mesh(given.file, *checked(mesh, "mesh").mesh));
    });
}

mien_status MIEN_CALL mien_landmarks_save(mien_session* session, const mien_landmarks* landmarks,
                                          const char* path, mien_error* error) {
    return guarded(error, [&] {
        const mien_landmarks& given = checked(landmarks, "landmarks");
        const Call call(session);
        write_landmark_file(checked_text(path, "path"), given.file);
    });
}

mien_status MIEN_CALL mien_landmarks_get_counts(const mien_landmarks* landmarks, uint64_t* count,
                                                uint64_t* picked_count, mien_error* error) {
    return guarded(error, [&] {
        const std::vector<Mark>& marks = checked(landmarks, "landmarks").file.marks;
        std::uint64_t picked = 0;
        for (const Mark& mark : marks) picked += mark.where != Mark::Where::not_picked;
        store(count, marks.size());
        store(picked_count, picked);
    });
}

mien_status MIEN_CALL mien_landmarks_get_name(const mien_landmarks* landmarks, uint64_t index,
                                              char* dst, uint64_t capacity, uint64_t* count,
                                              mien_error* error) {
    return guarded(error, [&] {
        const std::string& name = checked(landmarks, "landmarks").at(index).name;
        copy_text(name.data(), name.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_landmarks_get_mark(const mien_landmarks* landmarks, uint64_t index,
                                              int32_t* where, double* position, uint32_t* vertex,
                                              mien_error* error) {
    return guarded(error, [&] {
        const Mark& mark = checked(landmarks, "landmarks").at(index);
        check_output(position, "position");
        store(where, static_cast<std::int32_t>(mark.where));
        store(vertex, mark.vertex);
        if (position != nullptr)
            for (int k = 0; k < 3; ++k) position[k] = mark.point[k];
    });
}

mien_status MIEN_CALL mien_landmarks_get_json(const mien_landmarks* landmarks, char* dst,
                                              uint64_t capacity, uint64_t* count,
                                              mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(landmarks, "landmarks").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_landmarks_retain(mien_landmarks* landmarks) {
    retain(landmarks);
}

void MIEN_CALL mien_landmarks_release(mien_landmarks* landmarks) {
    release(landmarks);
}

mien_status MIEN_CALL mien_zones_load(mien_session* session, const char* path, mien_zones** out,
                                      mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return new mien_zones(read_zone_file(checked_text(path, "path"), call.context()));
    });
}

mien_status MIEN_CALL mien_zones_create(const mien_zone* zones, uint64_t zone_count,
                                        mien_zones** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        // No surface is named here to check against; none that a zone is drawn on is larger.
        constexpr Index kLargestSurface = Index{1} << 24;
        std::vector<Zone> list = read_zones(zones, zone_count, kLargestSurface, "zones");
        check_names(list, "zone");
        return new mien_zones(std::move(list));
    });
}

mien_status MIEN_CALL mien_model_get_zones(const mien_model* model, mien_zones** out,
                                           mien_error* error) {
    return guarded_create(out, error, [&] {
        return new mien_zones(std::vector<Zone>(checked(model, "model").model->zones));
    });
}

mien_status MIEN_CALL mien_zones_save(mien_session* session, const mien_zones* zones,
                                      const char* path, mien_error* error) {
    return guarded(error, [&] {
        const mien_zones& given = checked(zones, "zones");
        const Call call(session);
        write_zone_file(checked_text(path, "path"), given.zones);
    });
}

mien_status MIEN_CALL mien_zones_get_count(const mien_zones* zones, uint64_t* count,
                                           mien_error* error) {
    return guarded(error, [&] { store(count, checked(zones, "zones").zones.size()); });
}

mien_status MIEN_CALL mien_zones_get_name(const mien_zones* zones, uint64_t index, char* dst,
                                          uint64_t capacity, uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const std::string& name = checked(zones, "zones").at(index).name;
        copy_text(name.data(), name.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_zones_get_vertices(const mien_zones* zones, uint64_t index,
                                              uint32_t* dst, uint64_t capacity, uint64_t* count,
                                              mien_error* error) {
    return guarded(error, [&] {
        const std::vector<std::uint32_t>& vertices = checked(zones, "zones").at(index).vertices;
        copy_rows(vertices.data(), vertices.size(), sizeof(std::uint32_t), dst, capacity, count);
    });
}

void MIEN_CALL mien_zones_retain(mien_zones* zones) {
    retain(zones);
}

void MIEN_CALL mien_zones_release(mien_zones* zones) {
    release(zones);
}

}  // extern "C"
