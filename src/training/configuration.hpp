// Experiments as JSON files that build on each other. Each of "data", "representation", "model"
// and "experiment" is an object, the path of a file with one, or an object whose "base" is such a
// path and whose other entries replace the base's. Paths are relative to the file that names them.
//
// A table names lists: "models" and "representations"; every pair is one configuration.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "learning/face_features.hpp"
#include "learning/network_builder.hpp"
#include "training/trainer.hpp"

namespace mien::training {

struct DataChoice {
    std::string faces, split;  ///< paths
    bool neutral = true;       ///< neutral faces only
    /// Not empty: networks from neutral faces to this expression, by its name in the dataset.
    std::string expression;
    std::string oracle;  ///< a path: what a perfect predictor reaches, of mien-demo-data; or empty
};

/// Rows that keep a table of expressions honest.
inline constexpr const char* kRivals[] = {"mean-displacement", "deformation-transfer", "pca",
                                          "ridge", "banded-regression"};

struct Configuration {
    std::string name;  ///< of its folder
    DataChoice data;
    FeatureKind representation = FeatureKind::euclidean;
    FeatureSpread spread = FeatureSpread::per_vertex;
    /// Two networks over two bands, joined by assembly; `representation` has no meaning then.
    bool bands = false;
    Index band_limit = 500;  ///< modes of the low band; of expressions: how many are tried at most
    FeatureKind low_kind = FeatureKind::euclidean_standardised;
    FeatureKind high_kind = FeatureKind::deformation_normalised;
    bool pca = false;  ///< the linear model in the place of a network
    /// A rival without training in the place of a network (kRivals); else empty.
    std::string rival;
    bool two_step = false;  ///< of expressions: the encoder is a frozen autoencoder's (K 5.2.2)
    NetworkOptions model;
    TrainingSettings training;
    nlohmann::json text;  ///< all of it, as it was put together
};

struct Plan {
    std::string out;  ///< folder
    bool table = false;
    std::vector<Configuration> configurations;
};

/// `overrides` are "section.key=value", value being JSON or text; "out" too. Throws
/// Status::bad_format for keys that do not exist, with those that do.
Plan read_plan(const std::string& path, const std::vector<std::string>& overrides);

}  // namespace mien::training
