// The made-up study and models trained on it: made once, for every test that asks.
#pragma once

#include "expression/training.hpp"
#include "study.hpp"

namespace mien::test {

inline const Study& study() {
    static const Study made;
    return made;
}

/// All subjects, 8 expression modes.
template <int IdentityModes>
const ExpressionModel& trained_model() {
    static const std::shared_ptr<const ExpressionModel> trained = [] {
        TrainOptions options;
        options.subspaces.identity_modes = IdentityModes;
        options.subspaces.expression_modes = 8;
        const std::string tag = "trained_" + std::to_string(IdentityModes);
        return train_expression_model(study().dataset(0, study().subjects, tag), options,
                                      Context());
    }();
    return *trained;
}

}  // namespace mien::test
