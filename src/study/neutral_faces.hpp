// The faces of a study without their expressions, and what is known of the expressions that were
// taken off. One face: neutralize_mesh(). More: the joint fit of expression/visits.hpp, in which
// the treated vertices are no witness, extended behind the expression model's rim.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "expression/expression_model.hpp"
#include "expression/visits.hpp"
#include "study/study_face.hpp"

namespace mien {

struct NeutralFaces {
    std::vector<std::shared_ptr<const TriMesh>> meshes;  ///< in the frame of each face
    std::vector<std::string> expressions;  ///< name of each; empty: no model, or none named
    std::vector<Vector> expression_sd_mm;  ///< #V each: root of the summed posterior variance of a
                                           ///< vertex's coordinates; 0 behind the rim; empty: no
                                           ///< expression was taken off
    VisitsResult joint;                    ///< of more than one face; otherwise empty
};

/// model: null leaves the faces as they are. Faces are checked (check_study_faces()). Throws
/// Status::mismatch when the model's topology is no beginning of theirs, and as
/// neutralize_visits().
NeutralFaces neutral_faces(const Context& context, const ExpressionModel* model,
                           const std::vector<StudyFace>& faces,
                           const std::vector<std::uint32_t>& treated);

/// What the expressions move, as one linear map: displacement of vertex v = rows 3v .. 3v + 2 of
/// this (3#V of the model x q) times the expression's coordinates, in the training's frame.
Matrix expression_map(const ExpressionModel& model);

}  // namespace mien
