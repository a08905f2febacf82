// Faces of a dataset as a trainer wants them: people split into three lists, features in memory.
#pragma once

#include <string>
#include <vector>

#include "learning/band_features.hpp"
#include "learning/displacement_features.hpp"
#include "mesh/dataset.hpp"
#include "training/trainer.hpp"

namespace mien::training {

/// People, never faces: nobody stands in two lists.
struct SubjectSplit {
    std::vector<std::int32_t> training, validation, test;
};

/// 85 : 5 : 10 of the dataset's people, at least one each, by chance of the seed.
SubjectSplit make_split(const FaceDataset& data, std::uint64_t seed);
/// {"training": [...], "validation": [...], "test": [...]}; the second may be empty. Throws
/// Status::bad_format for anything else, and for a person in two lists.
SubjectSplit read_split(const std::string& path);
void write_split(const std::string& path, const SubjectSplit& split);

struct PreparedFaces {
    std::shared_ptr<const FaceFeatures> features;  ///< statistics of the training people alone
    TrainingData training, validation;
};
PreparedFaces prepare_faces(const FaceDataset& data, const SubjectSplit& split, bool neutral_only,
                            FeatureKind kind, FeatureSpread spread, const Context& context);

/// Two bands of every face, in the same order.
struct PreparedBands {
    std::shared_ptr<const BandFeatures> features;
    TrainingData low_training, low_validation, high_training, high_validation;
};
PreparedBands prepare_bands(const FaceDataset& data, const SubjectSplit& split, bool neutral_only,
                            const BandFeatureOptions& options, const Context& context);

/// The neutral faces of people and their faces with one expression; people without either are left
/// out. Throws Status::not_found for an expression that the dataset has not, or when nobody is
/// left. `data` must live as long as the pairs.
FacePairs expression_pairs(const FaceDataset& data, const std::vector<std::int32_t>& people,
                           const std::string& expression);

/// From neutral faces to displacements of one expression, both in one kind of features.
struct PreparedExpression {
    std::shared_ptr<const FaceFeatures> input, output;
    TrainingData training, validation;
};
PreparedExpression prepare_expression(const FaceDataset& data, const SubjectSplit& split,
                                      const std::string& expression, FeatureKind kind,
                                      FeatureSpread spread, const Context& context);

/// The dataset on a coarser template: quadric collapse of its mean face to about `vertices`.
void decimate_dataset(const FaceDataset& data, Index vertices, const std::string& path,
                      const Context& context);

/// Principal components of the training faces as a network of two dense layers: the linear model
/// of the same size that every table needs. `latent` is cut to the number of faces - 1.
NetworkLayers pca_network(const TrainingData& training, Index latent);

}  // namespace mien::training
