// Neutral faces of one person, of one or several visits, from the joint fit (joint_fit.hpp).
//
// Isotropic noise (vertices in true correspondence): neutral face k is face k less its expression's
// displacement, vertex by vertex. Noise along the normals (templates fitted to scans, which slide
// along the skin): the person's first neutral face with the expression b_k says where each vertex
// should be; its foot on the fitted surface k, less the expression's displacement there, is where
// it is. Neutral faces of one person are so in correspondence along the skin, and differ by what
// lies between the surfaces.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "expression/expression_model.hpp"
#include "expression/joint_fit.hpp"

namespace mien {

using VisitFace = JointFace;
using VisitsOptions = JointFitOptions;

struct VisitsResult {
    /// Per visit, in the frame of its face; where a face holds nothing finite, the shared face's.
    std::vector<Points> neutral_vertices;
    Points shared_vertices;  ///< the person's neutral face in the training's frame: mean of the
                             ///< visits' where they have data, the model's elsewhere
    Vector identity;         ///< a
    std::vector<Vector> expressions;      ///< b_k
    std::vector<std::string> components;  ///< name of each visit's mixture component; map: empty
    std::vector<Similarity> poses;        ///< training frame -> frame of the face
    Matrix covariance;                    ///< K q x K q, posterior of (b_1 .. b_K)
    std::vector<double> residuals_mm;     ///< distance of each face from its own fit per vertex
    /// Root mean square distance of each neutral face from the shared one, treated zone left out.
    std::vector<double> distances_mm;
};

/// Throws and costs as fit_faces().
VisitsResult neutralize_visits(const Context& context, const ExpressionModel& model,
                               const std::vector<VisitFace>& faces, const VisitsOptions& options);

/// What speaks against trusting visit `k`, in sentences; empty: nothing.
std::vector<std::string> visit_warnings(const ExpressionModel& model, const VisitsResult& result,
                                        std::size_t k);

/// What the expressions, taken off or not, add to the volume from visit `first` to visit `second`
/// over some of the model's vertices, mL, and the posterior's deviation of it.
struct RemovedVolume {
    double removed_ml = 0.0;
    double sd_ml = 0.0;
};
RemovedVolume removed_volume(const Context& context, const ExpressionModel& model,
                             const VisitsResult& visits, std::size_t first, std::size_t second,
                             const std::vector<std::uint32_t>& zone);

}  // namespace mien
