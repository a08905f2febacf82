// Faces as local deformations of a template: nine numbers a vertex (kosk-2024, 2.5, 4.12; Baran et
// al. 2009; Wu et al. 2018), and back by one prefactored sparse solve.
#pragma once

#include <memory>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// #V x c, one row a vertex.
using Features = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
constexpr int kDeformationChannels = 9;

/// Immutable after construction; shared freely between threads.
class DeformationRepresentation {
  public:
    /// Factorises once. Border vertices, flat and degenerate one-rings, pieces and loose vertices
    /// are all allowed. Throws Status::invalid_mesh or no_solution.
    DeformationRepresentation(const TriMesh& template_mesh, const Context& context);
    ~DeformationRepresentation();
    DeformationRepresentation(const DeformationRepresentation&) = delete;
    DeformationRepresentation& operator=(const DeformationRepresentation&) = delete;

    Index num_vertices() const;
    const TriMesh& template_mesh() const;

    /// #V x 9: the rotation vector of each vertex (rad, continuous over the surface, so that turns
    /// beyond pi stay whole), then S - I as xx yy zz xy xz yz. The template itself gives zeros.
    /// Invariant to translation.
    Features encode(const PointsRef& vertices, const Context& context) const;
    /// The face whose deformations are `features`. Each connected piece keeps the template's
    /// centre; with anchors (vertex numbers and places, mm) the pieces that hold some move so that
    /// these fit in the mean. decode(encode(x)) is x up to these translations.
    Points decode(const Eigen::Ref<const Features>& features, const Context& context) const;
    Points decode(const Eigen::Ref<const Features>& features,
                  const std::vector<std::uint32_t>& anchors, const PointsRef& anchor_places,
                  const Context& context) const;

    /// Deformation gradients as #V x 9 row-major 3 x 3 matrices, before the split into R and S.
    Features gradients(const PointsRef& vertices, const Context& context) const;
    Points from_gradients(const Eigen::Ref<const Features>& gradients,
                          const Context& context) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// T = R S with det R = +1 and S symmetric; exact for every T.
void polar_decomposition(const Matrix3& t, Matrix3& rotation, Matrix3& stretch);
/// Rotation vector (axis times angle in [0, pi]) and its inverse for vectors of any length.
Vector3 rotation_logarithm(const Matrix3& rotation);
Matrix3 rotation_exponential(const Vector3& vector);

}  // namespace mien
