// Trains a list of layers: Adam on the mean absolute error in the space of the representation after
// its statistics are undone (kosk-2024, 3.20 to 3.25). No type of libtorch in this header.
//
// Everything random comes from counters keyed by (seed, epoch, sample), so that training that was
// interrupted and resumed ends with the same bits as training that was not, on one CPU thread.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "learning/network_layers.hpp"

namespace mien::training {

struct TrainingSettings {
    int epochs = 450;             ///< >= 1
    int batch = 16;               ///< >= 1
    double learning_rate = 1e-3;  ///< > 0
    double decay = 0.99;          ///< of the learning rate, an epoch; 0 to 1
    double weight_decay = 0;      ///< L2, as Adam of libtorch has it
    double divergence = 1e-6;     ///< phi, of the KL term of a variational network; >= 0
    std::uint64_t seed = 1;
    bool frozen_encoder = false;  ///< the encoder stays; its mean code is decoded, without noise
    double conditioning = 1;  ///< gamma, of two bands: how much a decoder sees of the other's code
    int threads = 1;          ///< the bits depend on it
    int checkpoint_every = 10;  ///< epochs; 0: at the end alone
    int validate_every = 5;     ///< epochs; the last one always
    bool accelerator = false;   ///< CUDA; needs such a build of libtorch
};

/// Features as the network sees them, and what undoes the statistics.
struct TrainingData {
    Index faces = 0, rows = 0, channels = 0;
    std::vector<float> input;   ///< faces x rows x channels
    std::vector<float> output;  ///< the same of what is to be made; empty: the input
    /// rows x output channels: one unit of a feature in undone features. The error is weighed by
    /// it.
    std::vector<float> scale;

    const std::vector<float>& target() const { return output.empty() ? input : output; }
};

struct EpochRecord {
    int epoch = 0;
    double training_loss = 0;       ///< mean absolute error, undone features
    double divergence = 0;          ///< KL, without phi; 0 for a deterministic network
    double validation_loss = -1;    ///< -1: not validated in this epoch
    double seconds = 0;             ///< of the wall clock
    double high_training_loss = 0;  ///< of two bands: the first numbers are the low one's
    double high_validation_loss = -1;
};

struct TrainingResult {
    NetworkLayers last, best;  ///< best: least validation loss; the last without validation faces
    NetworkLayers high_last, high_best;  ///< of two bands; else empty
    std::vector<EpochRecord> epochs;
    int best_epoch = 0;
    bool finished = false;  ///< false: stopped; the checkpoint goes on from here
};

using EpochListener = std::function<void(const EpochRecord&, double seconds_left)>;

/// Goes on from `checkpoint` (a path; empty: none) when that file exists and was made of the same
/// network, data sizes and settings but the number of epochs; Status::mismatch otherwise. `stop`
/// is looked at after every step; then the state of the last whole epoch stands in the checkpoint.
/// Throws Status::no_solution when the loss is no number.
TrainingResult train(const NetworkLayers& network, const TrainingData& training,
                     const TrainingData& validation, const TrainingSettings& settings,
                     const std::string& checkpoint, const EpochListener& listener,
                     const std::atomic<bool>& stop);

/// One network with what it is trained on.
struct BandToTrain {
    const NetworkLayers& network;
    const TrainingData& training;
    const TrainingData& validation;  ///< of the same faces as the other band's, in the same order
};

/// Deep Spectral Meshes (kosk-2024, 4.13, 4.14): two autoencoders at once. Each decoder takes the
/// other band's code beside its own (NetworkOptions::conditioned), dropped element by element with
/// probability 1 - conditioning; no gradient goes into the other band's encoder, so each network
/// follows its own loss alone, by an optimiser of its own. conditioning = 0: zeros. Least
/// validation loss: of the sum of both, each over its first value.
TrainingResult train_bands(const BandToTrain& low, const BandToTrain& high,
                           const TrainingSettings& settings, const std::string& checkpoint,
                           const EpochListener& listener, const std::atomic<bool>& stop);

/// The reconstruction of every face, in features, by the trainer's own layers: for comparisons
/// with the evaluator. z = mean.
std::vector<float> reconstruct(const NetworkLayers& network, const TrainingData& data);

/// The same of the low band of a pair, as train_bands() validates it.
std::vector<float> reconstruct_bands(const BandToTrain& low, const BandToTrain& high,
                                     double conditioning);

/// Largest difference between gradients and central differences in double, over the largest
/// gradient of the same tensor, for the encoder's layers: of every weight tensor and of the input,
/// at up to `samples` places each.
double gradient_error(const NetworkLayers& network, std::uint64_t seed, int samples);

/// GFLOP/s of a 512^3 product in float on one thread: a BLAS that reaches less than 5 makes
/// training ten times slower than it need be (Debian: install libopenblas0-pthread).
double product_speed();

}  // namespace mien::training
