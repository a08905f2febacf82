// An expression carried from one face to another in correspondence (Sumner & Popovic 2004).
#pragma once

#include <memory>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Factorises the target once. Immutable afterwards; shared freely between threads.
class DeformationTransfer {
  public:
    /// Throws Status::invalid_mesh without triangles.
    DeformationTransfer(const TriMesh& target_neutral, const Context& context);
    ~DeformationTransfer();
    DeformationTransfer(const DeformationTransfer&) = delete;
    DeformationTransfer& operator=(const DeformationTransfer&) = delete;

    /// The target deformed as source_neutral -> source_expression: minimises sum_t A_t |J_t -
    /// S_t|^2 over the target's triangles. Each piece keeps the target's place plus the mean
    /// displacement of the source's piece. The same face as target and source gives the source's
    /// expression back.
    Points transfer(const PointsRef& source_neutral, const PointsRef& source_expression,
                    const Context& context) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace mien
