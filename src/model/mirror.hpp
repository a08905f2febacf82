// Left-right symmetry about the plane x = 0.
//
// A mirror-symmetric displacement has u_x odd and u_y, u_z even, so a prior in favour of symmetry
// needs another covariance for x than for y and z and no single scalar kernel can hold it. What one
// scalar basis can hold is this: every column purely even or purely odd. The preference is then a
// variance per column and axis, 1 + c for the symmetric combinations and 1 - c for the others,
// which keeps the total.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tri_mesh.hpp"
#include "model/low_rank.hpp"

namespace mien {

/// For each vertex the vertex nearest to its mirror image. Throws Status::invalid_mesh when an
/// image lies farther than the mean edge from every vertex, or two vertices do not point at each
/// other.
std::vector<std::uint32_t> mirror_map(const TriMesh& mesh, const Context& context);

/// principal_basis of the even and the odd part of K = factor factor', merged by strength; `parity`
/// of the result is +1 or -1 per column. A kernel that is not itself symmetric is symmetrised.
LowRankBasis mirrored_basis(const Matrix& factor, const Vector& diagonal,
                            const std::vector<std::uint32_t>& mirror, const RankOptions& options,
                            const Context& context);

/// r x 3.
Matrix mirrored_prior_variance(const std::vector<std::int8_t>& parity, double correlation);

}  // namespace mien
