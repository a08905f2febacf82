// From prepared kernel columns to a cut basis: the step that building and tuning share.
#pragma once

#include "model/kernel_blocks.hpp"
#include "model/low_rank.hpp"

namespace mien {

/// Control points, distances and eigenpairs for a basis of num_modes scalar modes.
/// num_control_points 0: max(1000, 3 num_modes), never more than #V.
KernelBlocks prepare_kernel_blocks(const TriMesh& mesh, const std::vector<KernelTerm>& terms,
                                   Index num_modes, Index num_control_points,
                                   const HeatOptions& heat, const Context& context);

/// scale_per_vertex: empty, or #V factors. mirror: null, or the partner of each vertex
/// (mirror.hpp).
LowRankBasis kernel_basis(const KernelBlocks& blocks, const std::vector<KernelTerm>& terms,
                          const RankOptions& rank, const Vector& scale_per_vertex,
                          const Context& context,
                          const std::vector<std::uint32_t>* mirror = nullptr);

}  // namespace mien
