// Coefficients of deformation models.
#include "model.hpp"

#include "arrays.hpp"
#include "guard.hpp"
#include "model/known_fit.hpp"
#include "options.hpp"
#include "registration.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

mien_model_fit_options default_fit_options() {
    mien_model_fit_options options{};
    options.ridge_mm2 = 1.0;
    options.scalar_modes = options.vector_modes = -1;
    return options;
}

KnownFitOptions read_fit_options(const mien_model_fit_options& given) {
    check_numbers({{"ridge_mm2", given.ridge_mm2}});
    KnownFitOptions options;
    options.align = read_switch(given.align, "options.align");
    options.ridge_mm2 = given.ridge_mm2;
    if (given.weights.count != 0) options.weights = read_values(given.weights, "options.weights");
    options.num_scalar_modes = given.scalar_modes;
    options.num_vector_modes = given.vector_modes;
    return options;
}

std::uint64_t coefficient_count_of(const DeformationModel& model) {
    return static_cast<std::uint64_t>(3 * model.basis.cols + model.pca_modes.cols);
}

/// 3 r + p values; modes that were not fitted are zero.
std::vector<double> flat(const DeformationModel& model, const ModelCoefficients& coefficients) {
    std::vector<double> values(coefficient_count_of(model), 0.0);
    for (Index j = 0; j < coefficients.kernel.rows(); ++j)
        for (Index c = 0; c < 3; ++c)
            values[static_cast<std::size_t>(3 * j + c)] = coefficients.kernel(j, c);
    for (Index j = 0; j < coefficients.pca.size(); ++j)
        values[static_cast<std::size_t>(3 * model.basis.cols + j)] = coefficients.pca[j];
    return values;
}

ModelCoefficients read_coefficients(const DeformationModel& model, const double* given,
                                    std::uint64_t count) {
    const std::uint64_t most = coefficient_count_of(model);
    const auto kernel = static_cast<std::uint64_t>(3 * model.basis.cols);
    if (count > most || (count < kernel && count % 3 != 0))
        fail(
            Status::mismatch,
            "coefficient_count is %llu; the model has %lld scalar modes of 3 and %lld vector modes",
            static_cast<unsigned long long>(count), static_cast<long long>(model.basis.cols),
            static_cast<long long>(model.pca_modes.cols));
    const std::vector<double> values = read_array(given, count, most, "coefficients");
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            fail_at(Status::invalid_argument, static_cast<std::int64_t>(i),
                    "coefficient %zu is not finite", i);
    ModelCoefficients coefficients;
    const std::uint64_t of_kernel = std::min(count, kernel);
    coefficients.kernel.resize(static_cast<Index>(of_kernel / 3), 3);
    for (std::uint64_t i = 0; i < of_kernel; ++i)
        coefficients.kernel(static_cast<Index>(i / 3), static_cast<Index>(i % 3)) = values[i];
    coefficients.pca.resize(static_cast<Index>(count - of_kernel));
    for (std::uint64_t i = of_kernel; i < count; ++i)
        coefficients.pca[static_cast<Index>(i - of_kernel)] = values[i];
    return coefficients;
}

void write_fit(const DeformationModel& model, const PointsRef& target,
               const KnownFitOptions& options, const Context& context, double* dst,
               std::uint64_t capacity, std::uint64_t* count) {
    const std::uint64_t rows = coefficient_count_of(model);
    if (!wants_copy(rows, dst, capacity, count)) return;
    const std::vector<double> values =
        flat(model, fit_known(model, target, options, context).coefficients);
    copy_rows(values.data(), rows, sizeof(double), dst, capacity, count);
}

}  // namespace

extern "C" {

void MIEN_CALL mien_model_fit_options_init(mien_model_fit_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_fit_options());
}

mien_status MIEN_CALL mien_model_fit(mien_session* session, const mien_model* model,
                                     const mien_mesh* target, const mien_model_fit_options* options,
                                     double* dst, uint64_t capacity, uint64_t* count,
                                     mien_error* error) {
    return guarded(error, [&] {
        const mien_model_fit_options given =
            read_options(options, default_fit_options(),
                         MIEN_FIRST_SIZE(mien_model_fit_options, vector_modes), "options");
        const DeformationModel& data = *checked(model, "model").model;
        const TriMesh& face = *checked(target, "target").mesh;
        const Call call(session);
        write_fit(data, face.vertices, read_fit_options(given), call.context(), dst, capacity,
                  count);
    });
}

mien_status MIEN_CALL mien_model_synthesize(mien_session* session, const mien_model* model,
                                            const double* coefficients, uint64_t coefficient_count,
                                            mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const DeformationModel& data = *checked(model, "model").model;
        const Call call(session);
        auto face = std::make_shared<TriMesh>(data.template_mesh);
        face->vertices += displacement(
            data, read_coefficients(data, coefficients, coefficient_count), call.context());
        return new mien_mesh(std::shared_ptr<const TriMesh>(std::move(face)));
    });
}

mien_status MIEN_CALL mien_registration_get_coefficients(mien_session* session,
                                                         const mien_registration* registration,
                                                         const mien_model* model, double ridge_mm2,
                                                         double* dst, uint64_t capacity,
                                                         uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const mien_registration& fit = checked(registration, "registration");
        const DeformationModel& data = *checked(model, "model").model;
        const Call call(session);
        const TriMesh& fitted = *fit.mesh->mesh;
        if (fitted.vertices.rows() != data.num_vertices())
            fail(Status::mismatch, "the registration has %lld vertices, the model's template %lld",
                 static_cast<long long>(fitted.vertices.rows()),
                 static_cast<long long>(data.num_vertices()));
        KnownFitOptions options;
        options.ridge_mm2 = ridge_mm2;
        write_fit(data, fit.data.motion.inverse().apply(fitted.vertices), options, call.context(),
                  dst, capacity, count);
    });
}

}  // extern "C"
