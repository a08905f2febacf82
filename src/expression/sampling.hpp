// Random faces of an expression model (J 4.2, figure 4.4) and expressions put onto other faces.
#pragma once

#include <cstdint>
#include <string>

#include "base/context.hpp"
#include "expression/expression_model.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Coordinates of a random face; the same seed gives the same numbers on every machine.
struct SampledCoordinates {
    Vector identity, expression;
};

/// `expression` names a component of the model, or is empty for no expression at all. Throws
/// Status::not_found.
SampledCoordinates sample_coordinates(const ExpressionModel& model, std::uint64_t seed,
                                      const std::string& expression);
Points sample_face(const Context& context, const ExpressionModel& model, std::uint64_t seed,
                   const std::string& expression);

/// A neutral face with an expression of the model added: the face may be larger than the model, as
/// in neutralize_mesh(); `pose` takes the model's frame into the face's.
Points transfer_expression(const Context& context, const ExpressionModel& model,
                           const TriMesh& neutral, const Similarity& pose,
                           const Vector& expression);

}  // namespace mien
