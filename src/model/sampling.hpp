// Faces from a deformation model: (2.3) with coefficients given or drawn.
#pragma once

#include <cstdint>

#include "base/context.hpp"
#include "model/deformation_model.hpp"

namespace mien {

/// Coefficients of a displacement: kernel r' x 3 and vector modes p', each in units of the prior's
/// deviation. Fewer rows than the model has modes leave the others at zero.
struct ModelCoefficients {
    Matrix kernel;
    Vector pca;
};

/// #V x 3, mm: mean + basis a + pca_modes c. Throws Status::mismatch for more coefficients than
/// modes.
Points displacement(const DeformationModel& model, const ModelCoefficients& coefficients,
                    const Context& context);

/// Random face number `index` of `seed`, the same whatever else was drawn: the template displaced
/// by the mean and `strength` times a draw from the prior.
TriMesh sample_face(const DeformationModel& model, std::uint64_t seed, std::uint64_t index,
                    double strength, const Context& context);

/// #V x 3: prior variance of each coordinate, mm^2.
Points pointwise_variance(const DeformationModel& model, const Context& context);

}  // namespace mien
