// One person's faces neutralized together: mien_visits_* along the normals, for measuring, and
// mien_series_* vertex by vertex. Thin forwards to the joint fit, kept for hosts of 0.1.
#include "expression/visits.hpp"
#include "arrays.hpp"
#include "expression.hpp"
#include "expression/neutralize_mesh.hpp"
#include "expression/report_json.hpp"
#include "expression_options.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

struct mien_visits : Object {
    static constexpr Tag kTag = Tag::visits;
    static constexpr const char* kName = "visits";
    mien_visits() : Object(kTag) {}
    std::shared_ptr<const ExpressionModel> model;
    std::vector<std::shared_ptr<const TriMesh>> neutrals;
    VisitsResult result;
};

namespace {

mien_visits_options default_visits_options() {
    const VisitsOptions core;
    mien_visits_options options{};
    options.normal_noise_mm2 = core.normal_noise_mm2;
    options.tangential_noise_mm2 = core.tangential_noise_mm2;
    return options;
}

mien_series_options default_series_options() {
    const VisitsOptions core;
    mien_series_options options{};
    options.method = MIEN_FIT_MIXTURE;
    options.scan_noise_share = core.face_noise_share;
    options.expected_change_mm = 5.0;
    return options;
}

VisitsOptions read_series_options(const mien_series_options& given, Index num_vertices) {
    check_fit(given.method, "options.method");
    check_pose(given.pose);
    check_numbers({{"scan_noise_share", given.scan_noise_share},
                   {"noise_mm2", given.noise_mm2},
                   {"expected_change_mm", given.expected_change_mm}});
    if (!(given.expected_change_mm > 0.0))
        fail(Status::invalid_argument, "options.expected_change_mm must be positive");
    if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
    VisitsOptions options;
    options.noise = JointNoise::isotropic;
    options.fit.method = static_cast<FitMethod>(given.method);
    options.fit.noise_mm2 = given.noise_mm2;
    options.pose = static_cast<Pose>(given.pose);
    options.face_noise_share = given.scan_noise_share;
    options.treated = read_vertices(given.changing_vertices, given.changing_count, num_vertices,
                                    "options.changing_vertices");
    return options;
}

VisitsOptions read_visits_options(const mien_visits_options& given, Index num_vertices) {
    check_pose(given.pose);
    check_numbers({{"normal_noise_mm2", given.normal_noise_mm2},
                   {"tangential_noise_mm2", given.tangential_noise_mm2}});
    VisitsOptions options;
    options.pose = static_cast<Pose>(given.pose);
    options.normal_noise_mm2 = given.normal_noise_mm2;
    options.tangential_noise_mm2 = given.tangential_noise_mm2;
    options.treated = read_vertices(given.treated_vertices, given.treated_count, num_vertices,
                                    "options.treated_vertices");
    return options;
}

std::vector<std::shared_ptr<const TriMesh>> read_faces(const mien_mesh* const* faces,
                                                       std::uint32_t count, std::uint32_t most) {
    if (count == 0) fail(Status::invalid_argument, "face_count is 0");
    check_array(faces, count, alignof(const mien_mesh*), most, "faces");
    std::vector<std::shared_ptr<const TriMesh>> meshes;
    for (std::uint32_t k = 0; k < count; ++k) meshes.push_back(checked(faces[k], "a face").mesh);
    return meshes;
}

/// The host's one list, cut into one per face.
std::vector<Vector> read_face_weights(const mien_array_view& view, std::size_t face_count,
                                      Index num_vertices) {
    if (view.count == 0) return {};
    check_view(view, 1, "options.weights");
    if (view.count != face_count * static_cast<std::uint64_t>(num_vertices))
        fail(Status::mismatch,
             "options.weights holds %llu numbers, not one per vertex of %zu faces of %lld vertices",
             static_cast<unsigned long long>(view.count), face_count,
             static_cast<long long>(num_vertices));
    const Vector all = read_values(view, "options.weights");
    std::vector<Vector> weights;
    for (std::size_t k = 0; k < face_count; ++k)
        weights.push_back(all.segment(static_cast<Index>(k) * num_vertices, num_vertices));
    return weights;
}

std::vector<std::shared_ptr<const TriMesh>> neutral_meshes(
    const std::vector<std::shared_ptr<const TriMesh>>& meshes, std::vector<Points>& vertices) {
    std::vector<std::shared_ptr<const TriMesh>> neutrals;
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        auto neutral = std::make_shared<TriMesh>(*meshes[k]);
        neutral->vertices = std::move(vertices[k]);
        neutrals.push_back(std::move(neutral));
    }
    return neutrals;
}

std::size_t checked_visit(const mien_visits& visits, std::int32_t index) {
    if (index < 0 || static_cast<std::size_t>(index) >= visits.neutrals.size())
        fail(Status::not_found, "visit %d of %zu", index, visits.neutrals.size());
    return static_cast<std::size_t>(index);
}

}  // namespace

extern "C" {

void MIEN_CALL mien_visits_options_init(mien_visits_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_visits_options());
}

mien_status MIEN_CALL mien_neutralize_visits(mien_session* session,
                                             const mien_expression_model* model,
                                             const mien_mesh* const* faces, uint32_t face_count,
                                             const mien_visits_options* options, mien_visits** out,
                                             mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_visits_options given =
            read_options(options, default_visits_options(),
                         MIEN_FIRST_SIZE(mien_visits_options, cancel), "options");
        const Call call(session, given.progress, given.progress_user, given.cancel);
        auto visits = std::make_unique<mien_visits>();
        visits->model = checked(model, "model").model;
        const auto meshes = read_faces(faces, face_count, 200);
        const Index all = meshes.front()->vertices.rows();
        visits->result = neutralize_visit_meshes(
            call.context(), *visits->model, meshes,
            read_face_weights(given.weights, meshes.size(), all), read_visits_options(given, all));
        std::vector<Points> vertices = visits->result.neutral_vertices;
        visits->neutrals = neutral_meshes(meshes, vertices);
        return visits.release();
    });
}

mien_status MIEN_CALL mien_visits_get_mesh(const mien_visits* visits, int32_t index,
                                           mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_visits& data = checked(visits, "visits");
        return new mien_mesh(data.neutrals[checked_visit(data, index)]);
    });
}

mien_status MIEN_CALL mien_visits_get_expression(const mien_visits* visits, int32_t index,
                                                 char* dst, uint64_t capacity, uint64_t* count,
                                                 mien_error* error) {
    return guarded(error, [&] {
        const mien_visits& data = checked(visits, "visits");
        const std::size_t k = checked_visit(data, index);
        const std::string name = k < data.result.components.size() ? data.result.components[k] : "";
        copy_text(name.data(), name.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_visits_get_removed_volume(const mien_visits* visits, int32_t first,
                                                     int32_t second, const mien_zone* zone,
                                                     double* removed_ml, double* sd_ml,
                                                     mien_error* error) {
    return guarded(error, [&] {
        const mien_visits& data = checked(visits, "visits");
        const std::size_t from = checked_visit(data, first), to = checked_visit(data, second);
        const Index all = data.neutrals.front()->vertices.rows();
        std::vector<std::uint32_t> vertices;
        if (zone != nullptr) {
            check_array(zone, 1, alignof(mien_zone), 1, "the zone");
            vertices = read_zone(*zone, all).vertices;
            for (const std::uint32_t vertex : vertices)
                if (vertex >= static_cast<std::uint64_t>(all))
                    fail(Status::mismatch, "the zone names vertex %u of %lld", vertex,
                         static_cast<long long>(all));
        } else {
            for (Index v = 0; v < all; ++v) vertices.push_back(static_cast<std::uint32_t>(v));
        }
        check_output(removed_ml, "removed_ml");
        check_output(sd_ml, "sd_ml");
        const RemovedVolume removed =
            removed_volume(Context(), *data.model, data.result, from, to, vertices);
        store(removed_ml, removed.removed_ml);
        store(sd_ml, removed.sd_ml);
    });
}

void MIEN_CALL mien_visits_release(mien_visits* visits) {
    release(visits);
}

void MIEN_CALL mien_series_options_init(mien_series_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_series_options());
}

mien_status MIEN_CALL mien_neutralize_series(mien_session* session,
                                             const mien_expression_model* model,
                                             const mien_mesh* const* faces, uint32_t face_count,
                                             const mien_series_options* options, mien_series** out,
                                             mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_series_options given =
            read_options(options, default_series_options(),
                         MIEN_FIRST_SIZE(mien_series_options, cancel), "options");
        const Call call(session, given.progress, given.progress_user, given.cancel);
        const ExpressionModel& data = *checked(model, "model").model;
        const auto meshes = read_faces(faces, face_count, 1000);
        const Index all = meshes.front()->vertices.rows();
        VisitsResult result = neutralize_visit_meshes(
            call.context(), data, meshes, read_face_weights(given.weights, meshes.size(), all),
            read_series_options(given, all));
        auto series = std::make_unique<mien_series>();
        auto identity = std::make_shared<TriMesh>(*meshes.front());
        identity->vertices = std::move(result.shared_vertices);
        series->identity = std::move(identity);
        series->json = visits_json(data, result);
        series->neutrals = neutral_meshes(meshes, result.neutral_vertices);
        return series.release();
    });
}

mien_status MIEN_CALL mien_series_get_mesh(const mien_series* series, int32_t index,
                                           mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_series& data = checked(series, "series");
        if (index < -1 || index >= static_cast<std::int32_t>(data.neutrals.size()))
            fail(Status::not_found, "face %d of a series of %zu", index, data.neutrals.size());
        return new mien_mesh(index == -1 ? data.identity
                                         : data.neutrals[static_cast<std::size_t>(index)]);
    });
}

mien_status MIEN_CALL mien_series_get_json(const mien_series* series, char* dst, uint64_t capacity,
                                           uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(series, "series").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_series_release(mien_series* series) {
    release(series);
}

}  // extern "C"
