#include "registration/inner_parts.hpp"

#include "model/sampling.hpp"

namespace mien {

InnerPartsState settle_inner_parts(const DeformationModel& model, const PriorState& prior,
                                   const FitState& state, const VertexRings& rings, Points places,
                                   const InnerSettings& inner, const FoldSettings& folds,
                                   const Context& context) {
    const TriMesh& mesh = model.template_mesh;
    const Points form = state.motion.apply(
        PointsRef(mesh.vertices +
                  displacement(model, {Matrix(), state.coefficients.pca.cast<double>()}, context)));
    InnerPartsState settled;
    settled.places = std::move(places);
    if (inner.carry) carry_inner(mesh, rings, form, prior.inner, inner, settled.places, context);
    settled.folds = straighten_turned(form, mesh.triangles, rings, folds, settled.places);
    return settled;
}

}  // namespace mien
