// Ways to a person's expression that need no training of a network. Every table of expressions
// prints them, so that a network is judged by what is there without it.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "spectral/spectral_basis.hpp"
#include "training/runs.hpp"

namespace mien::training {

/// The face with the expression, in the frame of the neutral one.
using PredictExpression = std::function<Points(const Points& neutral)>;

struct Rival {
    std::vector<PredictExpression> ways;  ///< several: their errors are averaged, not their faces
    Index numbers = 0;                    ///< of a code, where there is one
    double scale_mm = 1;
    nlohmann::json run;
};
/// The basis of a mean shape, and the numbers of modes to try.
using BasisFor = std::function<std::pair<std::shared_ptr<const SpectralBasis>, std::vector<Index>>(
    const TriMesh& mean)>;

/// The rival that the configuration names (kRivals), of the training people:
/// mean-displacement     the neutral face with the mean of the training people's displacements
/// deformation-transfer  from three training people (K 5.4: the mean of their errors)
/// pca                   least squares from the neutral face's principal components
/// ridge                 ridge regression on coordinates
/// banded-regression     ridge regression in two bands, k chosen on validation people
Rival make_rival(const RunContext& context, const BasisFor& basis_for);

}  // namespace mien::training
