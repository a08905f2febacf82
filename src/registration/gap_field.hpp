// The equations of the field that closes the gap,
//
//   (W + alpha L'L + e) delta = W gap,
//
// L the umbrella of the template's rings, by conjugate gradients. They are single: a field of some
// millimetres needs no more than six digits, and half of the bytes are moved. Vertices are ordered
// by their number of neighbours, so that no loop ends where one cannot foresee it.
#pragma once

#include <vector>

#include "base/context.hpp"
#include "mesh/adjacency.hpp"

namespace mien {

struct GapFieldSettings {
    double smoothness = 20;     ///< alpha, > 0 [J]
    double ground = 0.02;       ///< e, > 0 [J]
    int most_iterations = 80;   ///< >= 1: of conjugate gradients; tens are enough [J]
    double tolerance = 1e-8;    ///< > 0: of the squared residual [J]
    Index threads_from = 5000;  ///< vertices; waking threads costs more than smaller fields [J]
};

/// Of one template; holds its workspace. Not shared between threads.
class GapField {
  public:
    explicit GapField(const VertexRings& rings);

    /// delta, #V, from weights (#V, >= 0) and gaps (#V, mm). O(iterations #V).
    Vector solve(const Vector& weight, const Vector& gap, const GapFieldSettings& settings,
                 const Context& context);

  private:
    /// Vertices with as many neighbours, a part of them; `neighbours` column after column.
    struct Run {
        Index first, count;
        int degree;
        std::size_t neighbours;
    };

    void apply(const Context& context);
    double sum_of_products(const Eigen::ArrayXf& a, const Eigen::ArrayXf& b) const;

    Index n_;
    std::vector<Run> runs_;
    std::vector<std::uint32_t> neighbours_;
    std::vector<std::uint32_t> vertex_of_;  // by place in the order
    Eigen::ArrayXf diagonal_, delta_, residual_, direction_, image_, bent_, shared_;
    float smoothness_ = 0;
};

}  // namespace mien
