#include "study/neutral_faces.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "expression/neutralize_mesh.hpp"

namespace mien {
namespace {

NeutralFaces neutral_face(const Context& context, const ExpressionModel& model,
                          const StudyFace& face, const std::vector<std::uint32_t>& treated) {
    NeutralizeMeshOptions options;
    options.neutralize.uncertainty = true;
    options.neutralize.treated = treated;
    const NeutralizationResult result =
        neutralize_mesh(context, model, *face.mesh, face.weights, options);
    auto neutral = std::make_shared<TriMesh>(*face.mesh);
    neutral->vertices = result.neutral_vertices;
    NeutralFaces faces;
    faces.meshes.push_back(std::move(neutral));
    const std::vector<double>& likely = result.component_probabilities;
    faces.expressions.push_back(
        likely.empty() ? std::string()
                       : model
                             .components[static_cast<std::size_t>(
                                 std::max_element(likely.begin(), likely.end()) - likely.begin())]
                             .name);
    faces.expression_sd_mm.push_back(result.uncertainty_mm);
    return faces;
}

/// Root of the trace of each vertex's 3 x 3 block of E C E'.
Vector place_deviation(const Matrix& map, const Matrix& covariance, Index num_vertices) {
    const Matrix spread = map * covariance;
    Vector sd = Vector::Zero(num_vertices);
    for (Index v = 0; 3 * v < map.rows(); ++v) {
        double variance = 0.0;
        for (Index axis = 0; axis < 3; ++axis)
            variance += spread.row(3 * v + axis).dot(map.row(3 * v + axis));
        sd[v] = std::sqrt(std::max(0.0, variance));
    }
    return sd;
}

}  // namespace

Matrix expression_map(const ExpressionModel& model) {
    Matrix map = model.expression_modes.map().cast<double>();
    if (!model.spill.empty())
        map.noalias() += model.identity_modes.map().cast<double>() * model.spill.expression;
    return map;
}

NeutralFaces neutral_faces(const Context& context, const ExpressionModel* model,
                           const std::vector<StudyFace>& faces,
                           const std::vector<std::uint32_t>& treated) {
    NeutralFaces result;
    if (model == nullptr) {
        for (const StudyFace& face : faces) result.meshes.push_back(face.mesh);
        result.expressions.resize(faces.size());
        result.expression_sd_mm.resize(faces.size());
        return result;
    }
    if (faces.size() == 1) return neutral_face(context, *model, faces.front(), treated);
    std::vector<std::shared_ptr<const TriMesh>> meshes;
    std::vector<Vector> weights;
    for (const StudyFace& face : faces) {
        meshes.push_back(face.mesh);
        weights.push_back(face.weights);
    }
    VisitsOptions options;
    options.treated = treated;
    result.joint = neutralize_visit_meshes(context, *model, meshes, weights, options);
    const Matrix map = expression_map(*model);
    const Index q = model->num_expression_modes(), all = meshes.front()->vertices.rows();
    for (std::size_t k = 0; k < faces.size(); ++k) {
        context.check_cancelled();
        auto neutral = std::make_shared<TriMesh>(*meshes[k]);
        neutral->vertices = result.joint.neutral_vertices[k];
        result.meshes.push_back(std::move(neutral));
        result.expressions.push_back(k < result.joint.components.size() ? result.joint.components[k]
                                                                        : std::string());
        const Index at = static_cast<Index>(k) * q;
        result.expression_sd_mm.push_back(
            place_deviation(map, result.joint.covariance.block(at, at, q, q), all));
    }
    return result;
}

}  // namespace mien
