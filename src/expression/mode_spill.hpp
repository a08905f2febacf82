// What orthogonality takes away, given back to the prior.
//
// Quasi-orthogonal training (J 4.3) pushes every direction that identity and expression share into
// one of the two subspaces: a lowered jaw and a long chin then differ in Q or in P only, and v - Q
// b leaves the rest of the expression on the face. The two subspaces together still hold both, so a
// linear regression says which motion in P comes with an expression b and which shape in Q with an
// identity a:
//     v = mean + (P + Q R) a + (Q + P T) b + rest.
// a and b stay the coordinates along P and Q. Fits with a prior use this; the thesis' own fits
// (exact, alternating) and joint PCA, whose subspaces hold all they need, do not: R = 0, T = 0.
#pragma once

#include "base/types.hpp"

namespace mien {

struct ModeSpill {
    Matrix identity;    ///< R, q x p; empty for zero
    Matrix expression;  ///< T, p x q; empty for zero

    bool empty() const { return identity.size() == 0; }
    /// (a + T b, b + R a): coordinates along P and Q of the face with joint coordinates (a, b).
    Vector along_modes(const Vector& identity_coordinates,
                       const Vector& expression_coordinates) const;
    /// S' x for S = [I T; R I], and S' G S: evidence along the modes as evidence for (a, b).
    Vector pull_vector(const Vector& along) const;
    Matrix pull_gram(const Matrix& gram) const;
};

/// Both regressions, from training columns in coordinates along P and Q: neutrals (p x m and q x m)
/// and displacements (p x s and q x s).
ModeSpill learn_spill(const Matrix& neutrals_along_p, const Matrix& neutrals_along_q,
                      const Matrix& displacements_along_p, const Matrix& displacements_along_q);

}  // namespace mien
