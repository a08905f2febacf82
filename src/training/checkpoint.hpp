// One network being trained with its state, and the file from which an interrupted run goes on to
// the same bits.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "training/adam.hpp"
#include "training/torch_network.hpp"
#include "training/trainer.hpp"

namespace mien::training {

/// One network being trained, with all of its faces.
struct Half {
    Half(std::string prefix, const BandToTrain& band, const torch::Device& device)
        : name(std::move(prefix)),
          initial(band.network),
          training(band.training),
          validation(band.validation),
          model(band.network, torch::kFloat32, device),
          adam(model.weights()),
          last(band.network),
          best(band.network) {
        input = faces_of(training.input, training, training.channels, device);
        target = training.output.empty()
                     ? input
                     : faces_of(training.output, training, channels_out(), device);
        scale = blob(training.scale, {1, training.rows, channels_out()}).to(device);
    }

    Index channels_out() const { return initial.decoder.back().channels_out; }
    static Tensor blob(const std::vector<float>& values, std::vector<int64_t> sizes) {
        return torch::from_blob(const_cast<float*>(values.data()), sizes,
                                torch::TensorOptions().dtype(torch::kFloat32))
            .clone();
    }
    static Tensor faces_of(const std::vector<float>& values, const TrainingData& data,
                           Index channels, const torch::Device& device) {
        return blob(values, {data.faces, data.rows, channels}).to(device);
    }

    const std::string name;  ///< in front of its tensors in a checkpoint
    const NetworkLayers& initial;
    const TrainingData& training;
    const TrainingData& validation;
    TorchNetwork model;
    Adam adam;
    Tensor input, target, scale;
    NetworkLayers last, best;
};

using Halves = std::vector<std::unique_ptr<Half>>;

/// What a run must have in common with the one that its checkpoint came from.
std::string fingerprint(const Halves& halves, const TrainingSettings& settings);

/// Weights, moments, best weights and epochs so far.
void save_checkpoint(const std::string& path, const std::string& mark, const Halves& halves,
                     const TrainingResult& result, double best_loss);

/// Throws Status::mismatch for a checkpoint of another run.
void resume_checkpoint(const std::string& path, const std::string& mark, Halves& halves,
                       TrainingResult& result, double& best_loss);

}  // namespace mien::training
