#include "arrays.hpp"
#include "expression.hpp"
#include "expression/neutralize_mesh.hpp"
#include "expression/report_json.hpp"
#include "expression/scan_transfer.hpp"
#include "expression_options.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "registration.hpp"
#include "session.hpp"
#include "study/study_zones.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

mien_neutralize_options default_neutralize_options() {
    const NeutralizeMeshOptions core;
    mien_neutralize_options options{};
    options.method = MIEN_FIT_MIXTURE;
    options.max_sweeps = core.neutralize.fit.max_sweeps;
    options.tolerance_mm = core.neutralize.fit.tolerance;
    options.decay_mm = core.decay_mm;
    options.treated_margin_mm = StudyZoneSettings().margin_mm;
    return options;
}

NeutralizeMeshOptions read_neutralize_options(const mien_neutralize_options& given) {
    check_fit(given.method, "options.method");
    check_pose(given.pose);
    check_numbers({{"tolerance_mm", given.tolerance_mm},
                   {"noise_mm2", given.noise_mm2},
                   {"decay_mm", given.decay_mm},
                   {"treated_margin_mm", given.treated_margin_mm}});
    if (!(given.treated_margin_mm >= 0 && given.treated_margin_mm <= 100))
        fail(Status::invalid_argument, "options.treated_margin_mm is %g; give 0 to 100",
             given.treated_margin_mm);
    if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
    NeutralizeMeshOptions options;
    options.neutralize.fit.method = static_cast<FitMethod>(given.method);
    options.neutralize.fit.max_sweeps = given.max_sweeps;
    options.neutralize.fit.tolerance = given.tolerance_mm;
    options.neutralize.fit.noise_mm2 = given.noise_mm2;
    options.neutralize.pose = static_cast<Pose>(given.pose);
    options.neutralize.uncertainty = read_switch(given.uncertainty, "options.uncertainty");
    options.decay_mm = given.decay_mm;
    return options;
}

mien_neutralization* neutralize_face(mien_session* session, const ExpressionModel& model,
                                     std::shared_ptr<const TriMesh> face, const Vector* weights,
                                     const mien_neutralize_options* options) {
    const mien_neutralize_options given =
        read_options(options, default_neutralize_options(),
                     MIEN_FIRST_SIZE(mien_neutralize_options, cancel), "options");
    NeutralizeMeshOptions settings = read_neutralize_options(given);
    const Call call(session, given.progress, given.progress_user, given.cancel);
    Vector own;
    if (given.weights.count != 0)
        own = read_values(given.weights, "options.weights");
    else if (weights != nullptr)
        own = *weights;
    const std::vector<std::uint32_t> zone =
        read_vertices(given.treated, given.treated_count, face->vertices.rows(), "options.treated");
    if (!zone.empty())
        settings.neutralize.treated = with_margin(face->vertices, zone, given.treated_margin_mm);
    NeutralizationResult result = neutralize_mesh(call.context(), model, *face, own, settings);

    auto handle = std::make_unique<mien_neutralization>();
    if (!zone.empty()) {
        NeutralizeMeshOptions alone = settings;
        alone.neutralize.treated = zone;
        handle->readings = read_treated_zone(call.context(), model, *face, own, alone, result);
    }
    auto mesh = std::make_shared<TriMesh>(*face);
    mesh->vertices = std::move(result.neutral_vertices);
    handle->face = std::move(face);
    handle->mesh = new mien_mesh(std::move(mesh));
    handle->json =
        neutralization_json(model, result, handle->readings ? &*handle->readings : nullptr);
    handle->result = std::move(result);
    return handle.release();
}

}  // namespace

extern "C" {

void MIEN_CALL mien_neutralize_options_init(mien_neutralize_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_neutralize_options());
}

mien_status MIEN_CALL mien_neutralize(mien_session* session, const mien_expression_model* model,
                                      const mien_registration* fitted,
                                      const mien_neutralize_options* options,
                                      mien_neutralization** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        checked(session, "session");
        const mien_registration& registration = checked(fitted, "fitted");
        const ExpressionModel& data = *checked(model, "model").model;
        return neutralize_face(session, data, registration.mesh->mesh, &registration.data.weight,
                               options);
    });
}

mien_status MIEN_CALL mien_neutralize_mesh(mien_session* session,
                                           const mien_expression_model* model,
                                           const mien_mesh* face,
                                           const mien_neutralize_options* options,
                                           mien_neutralization** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        checked(session, "session");
        const ExpressionModel& data = *checked(model, "model").model;
        return neutralize_face(session, data, checked(face, "face").mesh, nullptr, options);
    });
}

mien_status MIEN_CALL mien_neutralization_apply_to_scan(mien_session* session,
                                                        const mien_neutralization* neutralization,
                                                        const mien_mesh* scan,
                                                        double max_distance_mm, mien_mesh** out,
                                                        mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        const mien_neutralization& source = checked(neutralization, "neutralization");
        const TriMesh& target = *checked(scan, "scan").mesh;
        ScanTransferOptions options;
        if (max_distance_mm != 0.0) options.max_distance_mm = max_distance_mm;
        ScanTransferResult moved = transfer_to_scan(call.context(), *source.face,
                                                    source.mesh->mesh->vertices, target, options);
        return new mien_mesh(std::make_shared<const TriMesh>(std::move(moved.scan)));
    });
}

const mien_mesh* MIEN_CALL mien_neutralization_mesh(const mien_neutralization* neutralization) {
    return is_live(neutralization) ? neutralization->mesh : nullptr;
}

mien_status MIEN_CALL mien_neutralization_get_counts(const mien_neutralization* neutralization,
                                                     uint64_t* vertex_count,
                                                     uint32_t* identity_modes,
                                                     uint32_t* expression_modes,
                                                     mien_error* error) {
    return guarded(error, [&] {
        const NeutralizationResult& result = checked(neutralization, "neutralization").result;
        store(vertex_count, result.neutral_vertices.rows());
        store(identity_modes, result.identity.size());
        store(expression_modes, result.expression.size());
    });
}

mien_status MIEN_CALL mien_neutralization_get_coordinates(const mien_neutralization* neutralization,
                                                          double* identity, double* expression,
                                                          mien_error* error) {
    return guarded(error, [&] {
        const NeutralizationResult& result = checked(neutralization, "neutralization").result;
        check_output(identity, "identity");
        check_output(expression, "expression");
        if (identity != nullptr)
            std::copy_n(result.identity.data(), result.identity.size(), identity);
        if (expression != nullptr)
            std::copy_n(result.expression.data(), result.expression.size(), expression);
    });
}

mien_status MIEN_CALL mien_neutralization_get_uncertainty(const mien_neutralization* neutralization,
                                                          double* dst, uint64_t capacity,
                                                          uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const Vector& values = checked(neutralization, "neutralization").result.uncertainty_mm;
        if (values.size() == 0)
            fail(Status::not_found,
                 "no uncertainty was computed: set options.uncertainty and use a fit with a prior");
        copy_rows(values.data(), static_cast<uint64_t>(values.size()), sizeof(double), dst,
                  capacity, count);
    });
}

mien_status MIEN_CALL mien_neutralization_get_reading(const mien_neutralization* neutralization,
                                                      int32_t reading, mien_zone_reading* out,
                                                      mien_error* error) {
    return guarded(error, [&] {
        const auto& readings = checked(neutralization, "neutralization").readings;
        check_choice(reading, MIEN_READING_TREATED, MIEN_READING_AS_EXPRESSION, "reading");
        if (!readings) fail(Status::not_found, "no zone of this face was called treated");
        const ZoneReading& one =
            reading == MIEN_READING_TREATED ? readings->treated : readings->as_expression;
        mien_zone_reading value{};
        value.differ = readings->differ ? 1 : 0;
        value.probability = one.probability;
        value.removed_mm = one.removed_mm;
        value.removed_ml = one.removed_ml;
        write_struct(out, value, MIEN_FIRST_SIZE(mien_zone_reading, removed_ml));
    });
}

mien_status MIEN_CALL mien_neutralization_get_json(const mien_neutralization* neutralization,
                                                   char* dst, uint64_t capacity, uint64_t* count,
                                                   mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(neutralization, "neutralization").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_neutralization_release(mien_neutralization* neutralization) {
    release(neutralization);
}

}  // extern "C"
