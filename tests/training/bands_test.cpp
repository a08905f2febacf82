// Two bands trained at once: each network follows its own loss, conditioning, the evaluator, bits
// after an interruption. And networks from a neutral face to an expression.
#include <gtest/gtest.h>

#include <cstring>

#include "base/error.hpp"
#include "spectral/metrics.hpp"
#include "training/configuration.hpp"
#include "training/faces.hpp"
#include "training/rivals.hpp"
#include "training/trainer.hpp"
#include "unit/learning/network_support.hpp"
#include "unit/scratch.hpp"

namespace mien::training {
namespace {

const std::atomic<bool> kGoOn{false};
void nobody(const EpochRecord&, double) {}

FaceDataset people_dataset(const std::string& path, const TriMesh& mesh, int people) {
    FaceDatasetWriter writer(mesh.triangles, mesh.vertices.rows(), {"neutral", "grin"});
    const FacePairs pairs = test::face_pairs(mesh, people);
    Points neutral, face;
    for (int k = 0; k < people; ++k) {
        pairs.pair(k, neutral, face);
        writer.add(neutral, k, 0);
        writer.add(face, k, 1);
    }
    writer.save(path, {});
    return FaceDataset::open(path, {}, {});
}

SubjectSplit split_of(int people) {
    SubjectSplit split;
    for (int k = 0; k < people; ++k)
        (k < people - 3   ? split.training
         : k < people - 1 ? split.validation
                          : split.test)
            .push_back(k);
    return split;
}

/// Bands of small faces with their untrained networks.
struct TwoBands {
    explicit TwoBands(NetworkOperator op) {
        const TriMesh mesh = test::face_like(10);
        const FaceDataset data = people_dataset(folder / "faces.safetensors", mesh, 10);
        BandFeatureOptions options;
        options.band_limit = 9;
        faces = prepare_bands(data, split_of(10), true, options, {});
        low = layers_of(op, 3, 1);
        high = layers_of(op, 9, 2);
    }
    NetworkLayers layers_of(NetworkOperator op, Index channels, std::uint64_t seed) const {
        NetworkOptions options;
        options.op = op;
        options.latent = 16;
        options.channels_in = options.channels_out = channels;
        options.conditioned = true;
        options.seed = seed;
        options.widths = {8, 16};
        options.mesh_widths = {8, 16, 16};
        options.bases = 6;
        return build_network(faces.features->mean(), options, {});
    }
    TrainingResult train(const TrainingSettings& settings, const std::string& state,
                         const std::atomic<bool>& stop = kGoOn,
                         const EpochListener& listener = nobody) const {
        return train_bands({low, faces.low_training, faces.low_validation},
                           {high, faces.high_training, faces.high_validation}, settings, state,
                           listener, stop);
    }
    testing::ScratchFolder folder;
    PreparedBands faces;
    NetworkLayers low, high;
};

TrainingSettings short_settings(int epochs, double conditioning) {
    TrainingSettings settings;
    settings.epochs = epochs;
    settings.batch = 4;
    settings.validate_every = 2;
    settings.conditioning = conditioning;
    return settings;
}

bool same_tensors(const NetworkLayers& a, const NetworkLayers& b) {
    for (const auto& [name, tensor] : a.tensors)
        if (std::memcmp(tensor.data, b.tensors.at(name).data,
                        static_cast<std::size_t>(tensor.count()) * 4) != 0)
            return false;
    return a.tensors.size() == b.tensors.size();
}

TEST(BandTraining, EachNetworkFollowsItsOwnLossAlone) {
    TwoBands bands(NetworkOperator::mesh_autoencoder);
    TrainingSettings settings = short_settings(1, 1);
    settings.batch = 16;  // one step: weights see the codes of untrained networks alone
    const TrainingResult before = bands.train(settings, "");
    for (float& value : bands.faces.high_training.scale) value *= 3;  // the high loss alone
    const TrainingResult after = bands.train(settings, "");
    EXPECT_TRUE(same_tensors(after.last, before.last)) << "no gradient of the other band's loss";
    EXPECT_FALSE(same_tensors(after.high_last, before.high_last));
    EXPECT_FALSE(same_tensors(before.last, bands.low));
    EXPECT_NEAR(after.epochs[0].high_training_loss, 3 * before.epochs[0].high_training_loss,
                1e-5 * after.epochs[0].high_training_loss);
    EXPECT_EQ(after.epochs[0].training_loss, before.epochs[0].training_loss);
}

TEST(BandTraining, WithoutConditioningOneBandDoesNotKnowTheOther) {
    TwoBands bands(NetworkOperator::spiralnet);
    for (const double conditioning : {0.0, 0.4, 1.0}) {
        const TrainingResult before = bands.train(short_settings(3, conditioning), "");
        TwoBands other(NetworkOperator::spiralnet);
        for (float& value : other.faces.high_training.input) value *= 0.7f;
        const TrainingResult after = other.train(short_settings(3, conditioning), "");
        EXPECT_EQ(same_tensors(after.last, before.last), conditioning == 0) << conditioning;
    }
}

TEST(BandTraining, GoesOnWithTheSameBits) {
    for (const NetworkOperator op :
         {NetworkOperator::mesh_autoencoder, NetworkOperator::spiralnet}) {
        const TwoBands bands(op);
        TrainingSettings settings = short_settings(6, 0.4);
        const TrainingResult whole = bands.train(settings, "");
        const std::string state = bands.folder / "state";
        settings.checkpoint_every = 1;
        std::atomic<bool> stop{false};
        const TrainingResult part =
            bands.train(settings, state, stop,
                        [&](const EpochRecord& record, double) { stop = record.epoch == 3; });
        EXPECT_FALSE(part.finished);
        const TrainingResult rest = bands.train(settings, state);
        EXPECT_TRUE(rest.finished);
        EXPECT_TRUE(same_tensors(rest.last, whole.last));
        EXPECT_TRUE(same_tensors(rest.high_last, whole.high_last));
        EXPECT_TRUE(same_tensors(rest.best, whole.best));
        EXPECT_TRUE(same_tensors(rest.high_best, whole.high_best));
        EXPECT_EQ(rest.best_epoch, whole.best_epoch);
        for (std::size_t k = 0; k < 6; ++k)
            EXPECT_EQ(rest.epochs[k].high_training_loss, whole.epochs[k].high_training_loss);
        settings.conditioning = 0.5;
        EXPECT_THROW(bands.train(settings, state), Error) << "a state of other settings";
    }
}

TEST(BandTraining, TrainerAndEvaluatorDecodeBothBandsAlike) {
    for (const double conditioning : {0.0, 1.0}) {
        const TwoBands bands(NetworkOperator::mesh_autoencoder);
        TrainingResult trained = bands.train(short_settings(3, conditioning), "");
        const auto part = [&](NetworkLayers layers,
                              const std::shared_ptr<const FaceFeatures>& features) {
            layers.variance.clear();
            return Network::make(std::move(layers), features, nullptr, {}, {});
        };
        const auto low = part(trained.last, bands.faces.features->shared_low());
        const auto high = part(trained.high_last, bands.faces.features->shared_high());
        const auto network = BandNetwork::make(
            {low, high, bands.faces.features->basis(), BandTask::faces, 9, conditioning}, {});
        const TrainingData& data = bands.faces.low_training;
        const auto reconstructed = reconstruct_bands(
            {trained.last, bands.faces.low_training, bands.faces.low_validation},
            {trained.high_last, bands.faces.high_training, bands.faces.high_validation},
            conditioning);
        const auto size = static_cast<std::size_t>(data.rows) * 3;
        double error = 0, largest = 0;
        for (const float value : data.input)
            largest = std::max(largest, std::fabs(static_cast<double>(value)));
        const Index rows = low->layers().decoder.front().rows_in;
        for (std::size_t k = 0; k < static_cast<std::size_t>(data.faces); ++k) {
            Eigen::VectorXf of_low(low->code_size()), of_high(high->code_size());
            low->encode_features(data.input.data() + k * size, of_low.data(), {});
            high->encode_features(bands.faces.high_training.input.data() + 3 * k * size,
                                  of_high.data(), {});
            if (conditioning == 0) of_high.setZero();
            const Features made = low->features_of(joined_codes(of_low, of_high, rows), {});
            for (std::size_t i = 0; i < size; ++i)
                error = std::max(
                    error,
                    std::fabs(made.data()[i] - static_cast<double>(reconstructed[k * size + i])));
        }
        EXPECT_LT(error, 1e-4 * largest);
        EXPECT_TRUE(network->apply(bands.faces.features->mean().vertices, {}).allFinite());
    }
}

TEST(ExpressionTraining, AFrozenEncoderStaysWhatItWas) {
    const testing::ScratchFolder folder;
    const TriMesh mesh = test::face_like(10);
    const FaceDataset data = people_dataset(folder / "faces.safetensors", mesh, 10);
    const PreparedExpression faces =
        prepare_expression(data, split_of(10), "grin", FeatureKind::euclidean_standardised,
                           FeatureSpread::per_channel, {});
    EXPECT_EQ(faces.training.faces, 7);
    EXPECT_EQ(faces.validation.faces, 2);
    NetworkOptions options;
    options.op = NetworkOperator::mesh_autoencoder;
    options.latent = 16;
    options.mesh_widths = {8, 16, 16};
    options.bases = 6;
    const NetworkLayers initial = build_network(faces.input->mean(), options, {});
    TrainingSettings settings = short_settings(60, 1);
    settings.learning_rate = 3e-3;
    settings.frozen_encoder = true;
    const TrainingResult trained =
        train(initial, faces.training, faces.validation, settings, "", nobody, kGoOn);
    EXPECT_LT(trained.epochs.back().training_loss, 0.5 * trained.epochs.front().training_loss);
    EXPECT_EQ(trained.epochs.back().divergence, 0) << "5.2.2: no sampling from a frozen encoder";
    for (const auto* list : {&initial.encoder, &initial.decoder})
        for (const NetworkLayer& layer : *list)
            for (const auto& [role, name] : layer.tensors)
                if (is_trained_role(layer.kind, role)) {
                    const NetworkTensor& a = initial.tensors.at(name);
                    const NetworkTensor& b = trained.last.tensors.at(name);
                    const bool same =
                        std::memcmp(a.data, b.data, static_cast<std::size_t>(a.count()) * 4) == 0;
                    EXPECT_EQ(same, list == &initial.encoder) << name;
                }
    EXPECT_THROW(prepare_expression(data, split_of(10), "frown", FeatureKind::euclidean,
                                    FeatureSpread::per_vertex, {}),
                 Error);
}

TEST(Rivals, KnowWhatIsTheSameForEverybody) {
    const testing::ScratchFolder folder;
    const TriMesh mesh = test::face_like(10);
    const FaceDataset data = people_dataset(folder / "faces.safetensors", mesh, 12);
    const SubjectSplit split = split_of(12);
    Configuration c;
    c.data.expression = "grin";
    c.model.latent = 4;
    const RunContext context{c, data, split, "", "", kGoOn};
    const BasisFor basis = [](const TriMesh& mean) {
        SpectralBasisOptions options;
        options.num_modes = 20;
        return std::make_pair(build_spectral_basis(mean, options, {}), std::vector<Index>{0, 10});
    };
    const FacePairs test = expression_pairs(data, split.test, "grin");
    Points neutral, face;
    test.pair(0, neutral, face);
    const double before = l1_distance(neutral, face);
    for (const char* name : kRivals) {
        c.rival = name;
        const Rival rival = make_rival(context, basis);
        ASSERT_FALSE(rival.ways.empty());
        for (const PredictExpression& way : rival.ways)
            EXPECT_LT(l1_distance(way(neutral), face), 0.7 * before) << name;
    }
}

}  // namespace
}  // namespace mien::training
