// Is there anything that is not linear for a network to find? What principal components leave of
// a face is predicted from its own numbers by a smooth function, without any training of a network.
#pragma once

#include "training/runs.hpp"

namespace mien::training {

struct CodeFunctionSettings {
    std::vector<double> ridges = {0.01, 0.1, 1,
                                  10,   100, 1000};  ///< > 0: tried on validation people
    Index most_faces = 1000;  ///< of the training: evenly chosen when there are more
};

/// Kernel ridge regression with (1 + z'w / K)^2, z and w whitened codes of K numbers, from the
/// codes of the training faces to what `pca` leaves of them; the ridge with the least L1 on
/// validation people (without any: training people). {"ridge", "test": errors_json()}. O(n^2 (n +
/// #V)).
nlohmann::json code_function_row(const RunContext& context, const FaceNetwork& pca,
                                 const CodeFunctionSettings& settings = {});

}  // namespace mien::training
