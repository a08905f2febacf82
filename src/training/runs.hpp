// The parts of runner.hpp: how each kind of configuration becomes a network and a row.
#pragma once

#include <atomic>
#include <memory>
#include <nlohmann/json.hpp>

#include "learning/network.hpp"
#include "learning/network_evaluation.hpp"
#include "training/configuration.hpp"
#include "training/faces.hpp"

namespace mien::training {

/// What a configuration is run on.
struct RunContext {
    const Configuration& configuration;
    const FaceDataset& data;
    const SubjectSplit& split;
    std::string folder;  ///< of the configurations' folders
    std::string room;    ///< of this one: folder/NAME/
    const std::atomic<bool>& stop;
};

/// Networks of the last epoch and of the least validation loss; null when `stop` came first.
struct MadeNetworks {
    std::shared_ptr<const FaceNetwork> last, best;
    nlohmann::json run;
};
/// An autoencoder of faces: single, over two bands, or PCA.
MadeNetworks make_face_networks(const RunContext& context);

/// The row of a configuration whose data.expression is given: a network, spectral assembly of two,
/// or a rival without training. Null when `stop` came first.
nlohmann::json run_expression(const RunContext& context);

/// What kosk-2024 shows of two bands in pictures, as numbers over pairs of people (4.17 to 4.19):
/// how far an exchange of one band's codes moves each band of the face, and how rough a face
/// half-way is against its parents, by the network and by coordinates.
nlohmann::json band_measures(const FaceNetwork& network, const FaceDataset& data,
                             const std::vector<Index>& faces);

/// Trains one network and leaves out what only training needs; `progress` counts.
nlohmann::json train_single(const RunContext& context, const NetworkLayers& initial,
                            const TrainingData& training, const TrainingData& validation,
                            const TrainingSettings& settings, NetworkLayers& last,
                            NetworkLayers& best);

/// {"faces", "l1_mm", "l2_mm", "l1_scaled", "dame", "fmpd"}. As kosk-2024 prints it, l1_scaled is a
/// mean over coordinates of faces scaled into [-1, 1].
nlohmann::json errors_json(const ReconstructionErrors& errors, double scale_mm);
/// configuration, name, model, representation, spread: what every row begins with.
nlohmann::json row_head(const Configuration& configuration);
void write_run_text(const std::string& path, const std::string& text);

}  // namespace mien::training
