// What the expressions' doubt does to a measure of two neutral faces, to first order.
//
// A measure with the slope g_v (a vector per vertex, unit per mm) changes by sum g_v . E_v (b_2 -
// b_1) when the expressions b_1, b_2 are left on; E_v is the expression map (neutral_faces.hpp).
// With the joint posterior of (b_1, b_2) its variance is s' (C_11 + C_22 - C_12 - C_21) s, s = sum
// E_v' g_v. What no training set holds adds a share of the removed amount itself.
#pragma once

#include "study/neutral_faces.hpp"

namespace mien {

/// For one pair of faces. Holds references: `map` and `faces` must outlive it.
class ExpressionError {
  public:
    /// map: expression_map(); first, second: places in faces.joint; normals: #V x 3, unit, in the
    /// first face's frame; #V may be more than the map has.
    ExpressionError(const Matrix& map, const NeutralFaces& faces, std::size_t first,
                    std::size_t second, const Points& normals);

    struct Part {
        double removed = 0.0;  ///< what the expressions accounted for
        double sd = 0.0;       ///< of the posterior
    };
    /// For a measure that grows by loads[v] per mm along the normal of vertex v.
    Part of_loads(const Vector& loads) const;
    /// The same for slopes in any direction, #V x 3, in the first face's frame.
    Part of_slopes(const Points& slopes) const;
    /// Deviation along the normal at each vertex, #V, mm: posterior and the untrained share of what
    /// was removed; 0 behind the model's rim.
    Vector normal_sd_mm(const ExpressionErrorSettings& settings) const;

  private:
    Part of_slope(const Vector& slope) const;
    const Matrix& map_;
    Matrix along_normal_;  // #V x q of the model: n_v' E_v
    Matrix3 rotation_;     // first face's frame -> training frame, with the scale
    Vector change_;        // b_2 - b_1
    Matrix spread_;        // its covariance
    Index num_vertices_;
};

}  // namespace mien
