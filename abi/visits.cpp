// Visits: one person's faces over time, neutralized together for measuring.
#include "expression/visits.hpp"
#include "arrays.hpp"
#include "expression.hpp"
#include "expression/neutralize_mesh.hpp"
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

/// Faces as the core takes them: the model's part of each mesh, which may be larger.
std::vector<VisitFace> visit_faces(const ExpressionModel& model,
                                   const std::vector<std::shared_ptr<const TriMesh>>& meshes,
                                   const mien_array_view& view) {
    const Index all = meshes.front()->vertices.rows(), n = model.num_vertices();
    Vector weights;
    if (view.count != 0) {
        if (view.count != meshes.size() * static_cast<std::uint64_t>(all))
            fail(Status::mismatch,
                 "options.weights holds %llu numbers, not one per vertex of %zu faces of %lld "
                 "vertices",
                 static_cast<unsigned long long>(view.count), meshes.size(),
                 static_cast<long long>(all));
        weights = read_values(view, "options.weights");
    }
    std::vector<VisitFace> faces;
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        const TriMesh& mesh = *meshes[k];
        if (mesh.vertices.rows() != all ||
            match_topology(model, all, mesh.triangles) == TopologyMatch::none)
            fail(Status::mismatch,
                 "face %zu (%lld vertices) is not in the expression model's topology (%lld "
                 "vertices), or not in that of "
                 "the first face: register all with the template that the model's faces were made "
                 "with",
                 k, static_cast<long long>(mesh.vertices.rows()), static_cast<long long>(n));
        faces.push_back(
            {mesh.vertices.topRows(n), weights.size() != 0
                                           ? Vector(weights.segment(static_cast<Index>(k) * all, n))
                                           : Vector()});
    }
    return faces;
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
        check_pose(given.pose);
        check_numbers({{"normal_noise_mm2", given.normal_noise_mm2},
                       {"tangential_noise_mm2", given.tangential_noise_mm2}});
        if (given.weights.count != 0) check_view(given.weights, 1, "options.weights");
        if (face_count == 0) fail(Status::invalid_argument, "face_count is 0");
        check_array(faces, face_count, alignof(const mien_mesh*), 200, "faces");
        std::vector<std::shared_ptr<const TriMesh>> meshes;
        for (uint32_t k = 0; k < face_count; ++k)
            meshes.push_back(checked(faces[k], "a face").mesh);
        const Index all = meshes.front()->vertices.rows(), n = visits->model->num_vertices();
        VisitsOptions settings;
        settings.pose = static_cast<Pose>(given.pose);
        settings.normal_noise_mm2 = given.normal_noise_mm2;
        settings.tangential_noise_mm2 = given.tangential_noise_mm2;
        const std::vector<VisitFace> parts = visit_faces(*visits->model, meshes, given.weights);
        for (const std::uint32_t vertex : read_vertices(given.treated_vertices, given.treated_count,
                                                        all, "options.treated_vertices")) {
            if (vertex >= static_cast<std::uint64_t>(all))
                fail(Status::mismatch, "options.treated_vertices names vertex %u of %lld", vertex,
                     static_cast<long long>(all));
            if (vertex < static_cast<std::uint64_t>(n))
                settings.treated.push_back(vertex);  // no expression behind the rim
        }
        visits->result = neutralize_visits(call.context(), *visits->model, parts, settings);
        for (uint32_t k = 0; k < face_count; ++k) {
            auto neutral = std::make_shared<TriMesh>(*meshes[k]);
            const Points moved = visits->result.neutral_vertices[k] - parts[k].vertices;
            neutral->vertices += extend_displacement(neutral->vertices, neutral->triangles, moved,
                                                     NeutralizeMeshOptions().decay_mm);
            visits->neutrals.push_back(std::move(neutral));
        }
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

}  // extern "C"
