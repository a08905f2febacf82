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
};

struct Configuration {
    std::string name;  ///< of its folder
    DataChoice data;
    FeatureKind representation = FeatureKind::euclidean;
    FeatureSpread spread = FeatureSpread::per_vertex;
    bool pca = false;  ///< the linear model in the place of a network
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
