// Coefficients of deformation models, and distances along a surface, in the C++ face.
#ifndef MIEN_DETAIL_MODEL_FIT_HPP
#define MIEN_DETAIL_MODEL_FIT_HPP

#include "model.hpp"
#include "registration.hpp"

namespace mien {

/// The settings of mien_model_fit_options; see there for units, ranges and defaults.
struct ModelFitSettings {
    double ridge_mm2 = 1;
    std::vector<double> weights;  ///< one per vertex of the target, or empty
    int scalar_modes = -1, vector_modes = -1;
    bool align = false;
};

/// 3 r + p coefficients of the model's face nearest to `target`, which has the template's vertices.
inline std::vector<double> fit_model(const Session& session, const Model& model, const Mesh& target,
                                     const ModelFitSettings& settings = {}) {
    mien_model_fit_options options;
    mien_model_fit_options_init(&options, sizeof options);
    options.ridge_mm2 = settings.ridge_mm2;
    options.align = settings.align ? 1 : 0;
    options.scalar_modes = settings.scalar_modes;
    options.vector_modes = settings.vector_modes;
    if (!settings.weights.empty())
        options.weights = {settings.weights.data(), settings.weights.size(), 0, MIEN_DTYPE_F64, 0};
    std::vector<double> values(3 * model.scalar_modes() + model.vector_modes());
    std::uint64_t count = 0;
    detail::call(mien_model_fit, session.get(), model.get(), target.get(), &options, values.data(),
                 std::uint64_t{values.size()}, &count);
    return values;
}

/// The same of a registration to this model; ridge 0: the nearest face of the model's span.
inline std::vector<double> coefficients_of(const Session& session, const Registration& fitted,
                                           const Model& model, double ridge_mm2 = 0) {
    std::vector<double> values(3 * model.scalar_modes() + model.vector_modes());
    std::uint64_t count = 0;
    detail::call(mien_registration_get_coefficients, session.get(), fitted.get(), model.get(),
                 ridge_mm2, values.data(), std::uint64_t{values.size()}, &count);
    return values;
}

/// The face of these coefficients; fewer leave the other modes at zero.
inline Mesh synthesize(const Session& session, const Model& model,
                       const std::vector<double>& coefficients) {
    mien_mesh* mesh = nullptr;
    detail::call(mien_model_synthesize, session.get(), model.get(), coefficients.data(),
                 std::uint64_t{coefficients.size()}, &mesh);
    return Mesh(mesh);
}

/// The settings of mien_geodesic_options.
struct GeodesicSettings {
    std::int32_t heat_boundary = MIEN_HEAT_NEUMANN;
    double heat_time_factor = 4;
    Progress progress;
    mien_cancel* cancel = nullptr;
};

/// Distance of each vertex from the nearest source along the surface, mm.
inline std::vector<double> geodesic_distances(const Session& session, const Mesh& mesh,
                                              const std::vector<std::uint32_t>& sources,
                                              const GeodesicSettings& settings = {}) {
    mien_geodesic_options options;
    mien_geodesic_options_init(&options, sizeof options);
    options.heat_boundary = settings.heat_boundary;
    options.heat_time_factor = settings.heat_time_factor;
    options.cancel = settings.cancel;
    detail::ProgressBridge bridge(settings.progress);
    bridge.install(options);
    std::vector<double> field(mesh.vertex_count());
    std::uint64_t count = 0;
    bridge.call(mien_measure_geodesic, session.get(), mesh.get(), sources.data(),
                std::uint64_t{sources.size()}, &options, field.data(), std::uint64_t{field.size()},
                &count);
    return field;
}

}  // namespace mien

#endif
