// The trainer against central differences, against the evaluator, and against itself interrupted.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.hpp"
#include "training/code_function.hpp"
#include "training/configuration.hpp"
#include "training/faces.hpp"
#include "training/steered_mix.hpp"
#include "training/trainer.hpp"
#include "unit/learning/network_support.hpp"
#include "unit/scratch.hpp"

namespace mien::training {
namespace {

using mien::test::kAllOperators;

const std::atomic<bool> kGoOn{false};
void nobody(const EpochRecord&, double) {}

/// Smooth faces over a template, in features.
PreparedFaces some_faces(const TriMesh& mesh, Index count, FeatureKind kind) {
    PreparedFaces faces;
    const FaceSource source = test::face_source(mesh, count);
    faces.features = FaceFeatures::train(mesh.triangles, source, kind, {});
    TrainingData& data = faces.training;
    data.faces = count;
    data.rows = mesh.vertices.rows();
    data.channels = faces.features->num_channels();
    Points face;
    for (Index k = 0; k < count; ++k) {
        source.face(k, face);
        const Features f = faces.features->encode(face, nullptr, {});
        for (Index i = 0; i < f.size(); ++i) data.input.push_back(static_cast<float>(f.data()[i]));
    }
    const Features unit = faces.features->restore(Features::Ones(data.rows, data.channels)) -
                          faces.features->restore(Features::Zero(data.rows, data.channels));
    for (Index i = 0; i < unit.size(); ++i)
        data.scale.push_back(static_cast<float>(unit.data()[i]));
    return faces;
}

NetworkLayers untrained(const PreparedFaces& faces, NetworkOperator op, Index latent = 16) {
    NetworkOptions options;
    options.op = op;
    options.latent = latent;
    options.channels_in = options.channels_out = faces.training.channels;
    options.widths = {8, 16, 16};
    options.mesh_widths = {8, 16, 16, 16};
    options.bases = 8;
    return build_network(faces.features->mean(), options, {});
}

TEST(Training, GradientsOfEveryLayerKindAreCentralDifferences) {
    std::uint64_t seed = 1;
    for (const LayerKind kind :
         {LayerKind::gather, LayerKind::steered, LayerKind::basis, LayerKind::permuted,
          LayerKind::dense, LayerKind::pick, LayerKind::sparse, LayerKind::elu, LayerKind::affine})
        for (int variant = 0; variant < 3; ++variant) {
            if (kind == LayerKind::steered && variant == 1) continue;  // too steep for differences
            const bool fixed = kind == LayerKind::pick || kind == LayerKind::sparse ||
                               kind == LayerKind::elu || kind == LayerKind::affine;
            const bool same = kind == LayerKind::elu || kind == LayerKind::affine ||
                              (kind == LayerKind::basis && variant == 1);
            const NetworkLayers network = test::random_layer(
                kind, 14, 5, same ? 14 : 9, fixed || same ? 5 : 7, variant != 2, variant, ++seed);
            EXPECT_LT(gradient_error(network, seed, 25), 1e-6)
                << layer_kind_name(kind) << ", variant " << variant;
        }
}

TEST(Training, NeighboursAreMixedInOnePassAsByTheProductsOfAccelerators) {
    torch::manual_seed(1);
    const auto doubles = torch::TensorOptions().dtype(torch::kFloat64);
    const torch::Tensor entries = torch::tensor({3, 1, 4, 2}, torch::kInt64);
    const torch::Tensor neighbour = torch::randint(6, {4 * 4}, torch::kInt64);
    const torch::Tensor there = (torch::arange(4).view({1, 4}) < entries.view({4, 1})).to(doubles);
    const torch::Tensor direction = torch::randn({2, 4, 3 * 11}, doubles);
    std::vector<torch::Tensor> made;
    const torch::Tensor steer = torch::randn({2, 4, 4, 3}, doubles),
                        x = torch::randn({2, 6, 11}, doubles);
    for (const bool one_pass : {true, false}) {
        const torch::Tensor s = steer.clone().requires_grad_(true),
                            from = x.clone().requires_grad_(true);
        const torch::Tensor shares = s * there.view({1, 4, 4, 1});
        const torch::Tensor mixed = one_pass ? steered_mix(shares, from, neighbour, entries)
                                             : steered_mix_by_products(shares, from, neighbour);
        (mixed * direction).sum().backward();
        for (const torch::Tensor& result : {mixed, s.grad(), from.grad()})
            made.push_back(result.detach());
    }
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_GT(made[k].abs().max().item<double>(), 0.1);
        EXPECT_LT((made[k] - made[k + 3]).abs().max().item<double>(), 1e-12);
    }
}

TEST(Training, TrainerAndEvaluatorRunTheSameNetwork) {
    const TriMesh mesh = test::face_like(16);
    for (const FeatureKind kind :
         {FeatureKind::euclidean_standardised, FeatureKind::deformation_normalised})
        for (const NetworkOperator op : kAllOperators) {
            const PreparedFaces faces = some_faces(mesh, 4, kind);
            NetworkLayers layers = untrained(faces, op);
            const std::vector<float> trained = reconstruct(layers, faces.training);
            layers.variance.clear();
            const auto network = Network::make(std::move(layers), faces.features, nullptr, {}, {});
            const std::size_t size =
                static_cast<std::size_t>(faces.training.rows * faces.training.channels);
            std::vector<float> code(static_cast<std::size_t>(network->code_size())), out(size);
            double error = 0, largest = 0;  // the size of the faces, as features have it
            for (const float value : faces.training.input)
                largest = std::max(largest, std::fabs(static_cast<double>(value)));
            for (std::size_t k = 0; k < 4; ++k) {
                network->encode_features(faces.training.input.data() + k * size, code.data(), {});
                network->decode_features(code.data(), out.data(), {});
                for (std::size_t i = 0; i < size; ++i)
                    error = std::max(error, std::fabs(static_cast<double>(out[i]) -
                                                      static_cast<double>(trained[k * size + i])));
            }
            EXPECT_LT(error, 1e-4 * largest) << network_operator_name(op);
        }
}

bool same_weights(const NetworkLayers& a, const NetworkLayers& b) {
    for (const auto& [name, tensor] : a.tensors)
        if (std::memcmp(tensor.data, b.tensors.at(name).data,
                        static_cast<std::size_t>(tensor.count()) * 4) != 0)
            return false;
    return a.tensors.size() == b.tensors.size();
}

TEST(Training, GoesOnWithTheSameBits) {
    const testing::ScratchFolder folder;
    const PreparedFaces faces = some_faces(test::face_like(10), 11, FeatureKind::euclidean);
    for (const NetworkOperator op : kAllOperators) {
        const NetworkLayers layers = untrained(faces, op);
        TrainingSettings settings;
        settings.epochs = 6;
        settings.batch = 4;
        settings.validate_every = 2;
        const TrainingResult whole =
            train(layers, faces.training, faces.training, settings, "", nobody, kGoOn);
        EXPECT_TRUE(whole.finished);
        EXPECT_FALSE(same_weights(whole.last, layers));
        const std::string state = folder / (std::string(network_operator_name(op)) + ".state");
        settings.epochs = 3;
        train(layers, faces.training, faces.training, settings, state, nobody, kGoOn);
        // Stopped in the middle of an epoch, which is then forgotten.
        settings.epochs = 6;
        settings.checkpoint_every = 1;
        std::atomic<bool> stop{false};
        const TrainingResult part = train(
            layers, faces.training, faces.training, settings, state,
            [&](const EpochRecord& record, double) { stop = record.epoch == 4; }, stop);
        EXPECT_FALSE(part.finished);
        EXPECT_EQ(part.epochs.size(), 4u);
        const TrainingResult rest =
            train(layers, faces.training, faces.training, settings, state, nobody, kGoOn);
        EXPECT_TRUE(same_weights(rest.last, whole.last)) << network_operator_name(op);
        EXPECT_TRUE(same_weights(rest.best, whole.best)) << network_operator_name(op);
        EXPECT_EQ(rest.best_epoch, whole.best_epoch);
        ASSERT_EQ(rest.epochs.size(), 6u);
        for (std::size_t k = 0; k < 6; ++k)
            EXPECT_EQ(rest.epochs[k].training_loss, whole.epochs[k].training_loss);
        settings.learning_rate = 2e-3;
        EXPECT_THROW(train(layers, faces.training, faces.training, settings, state, nobody, kGoOn),
                     Error)
            << "a state of other settings";
    }
}

TEST(Training, EveryOperatorLearnsAFewFaces) {
    const PreparedFaces faces =
        some_faces(test::face_like(10), 8, FeatureKind::euclidean_standardised);
    for (const NetworkOperator op : kAllOperators) {
        TrainingSettings settings;
        settings.epochs = 150;
        settings.batch = 8;
        settings.learning_rate = 3e-3;
        settings.decay = 0.995;
        const TrainingResult result =
            train(untrained(faces, op), faces.training, {}, settings, "", nobody, kGoOn);
        EXPECT_LT(result.epochs.back().training_loss, 0.5 * result.epochs.front().training_loss)
            << network_operator_name(op);
        EXPECT_EQ(result.epochs.back().divergence > 0, op == NetworkOperator::mesh_autoencoder);
    }
}

TEST(Training, TheLossIsTakenInUndoneFeatures) {
    // Twice the scale is twice the loss, whatever the features are.
    PreparedFaces faces = some_faces(test::face_like(8), 4, FeatureKind::euclidean_standardised);
    TrainingSettings settings;
    settings.epochs = 1;
    const NetworkLayers layers = untrained(faces, NetworkOperator::spiralnet);
    const double once =
        train(layers, faces.training, {}, settings, "", nobody, kGoOn).epochs[0].training_loss;
    for (float& value : faces.training.scale) value *= 2;
    const double twice =
        train(layers, faces.training, {}, settings, "", nobody, kGoOn).epochs[0].training_loss;
    EXPECT_NEAR(twice, 2 * once, 1e-6 * twice);
}

TEST(Training, PrincipalComponentsGiveTheirOwnFacesBack) {
    const PreparedFaces faces = some_faces(test::face_like(8), 6, FeatureKind::euclidean);
    const NetworkLayers layers = pca_network(faces.training, 64);
    EXPECT_EQ(layers.encoder[0].channels_out, 5) << "six faces span five directions";
    const std::vector<float> back = reconstruct(layers, faces.training);
    for (std::size_t k = 0; k < back.size(); ++k)
        ASSERT_NEAR(back[k], faces.training.input[k], 2e-5);
    const NetworkLayers one = pca_network(faces.training, 1);
    const auto network = Network::make(one, faces.features, nullptr, {"pca", ""}, {});
    EXPECT_EQ(network->code_size(), 1);
}

FaceDataset written_dataset(const std::string& path, const TriMesh& mesh, int people) {
    FaceDatasetWriter writer(mesh.triangles, mesh.vertices.rows(), {"neutral", "grin"});
    for (int k = 0; k < 2 * people; ++k)
        writer.add(test::bent(mesh.vertices, 0.2 * k), k / 2, k % 2);
    writer.save(path, {});
    return FaceDataset::open(path, {}, {});
}

/// People along one direction, and along its square in another one when they are curved.
FaceDataset dataset_along_a_line(const std::string& path, const TriMesh& mesh, int people,
                                 double curved) {
    FaceDatasetWriter writer(mesh.triangles, mesh.vertices.rows(), {"neutral"});
    for (int k = 0; k < people; ++k) {
        const double t = 2 * test::noise(static_cast<std::uint64_t>(k));
        Points face = mesh.vertices;
        for (Index v = 0; v < face.rows(); ++v) {
            const double x = 0.1 * face(v, 0), y = 0.1 * face(v, 1);
            face(v, 2) += t * std::cos(x) + curved * t * t * std::cos(y);
        }
        writer.add(test::noisy(face, 0.05, static_cast<std::uint64_t>(1000 * k)), k, 0);
    }
    writer.save(path, {});
    return FaceDataset::open(path, {}, {});
}

TEST(CodeFunction, TellsCurvedFacesFromStraightOnes) {
    const testing::ScratchFolder folder;
    const TriMesh mesh = test::face_like(12);
    for (const double curved : {0.0, 0.4}) {
        const FaceDataset data =
            dataset_along_a_line(folder / "faces.safetensors", mesh, 40, curved);
        const SubjectSplit split = make_split(data, 1);
        const PreparedFaces faces =
            prepare_faces(data, split, true, FeatureKind::euclidean, FeatureSpread::per_vertex, {});
        const auto pca =
            Network::make(pca_network(faces.training, 1), faces.features, nullptr, {"pca", ""}, {});
        const double left = ReconstructionErrors::mean(
            reconstruction_errors(data, chosen_faces(data, split.test, true),
                                  [&](const Points& face) { return pca->apply(face, {}); }, false,
                                  {})
                .l1_mm);
        const nlohmann::json row =
            code_function_row({Configuration(), data, split, "", "", kGoOn}, *pca);
        const double with_function = row["test"]["l1_mm"];
        if (curved > 0)
            EXPECT_LT(with_function, 0.6 * left);
        else
            EXPECT_NEAR(with_function, left, 0.2 * left);
    }
}

TEST(Split, PutsEveryPersonIntoOneList) {
    const testing::ScratchFolder folder;
    const TriMesh mesh = test::face_like(8);
    const FaceDataset data = written_dataset(folder / "faces.safetensors", mesh, 40);
    const SubjectSplit split = make_split(data, 1);
    EXPECT_EQ(split.test.size(), 4u);
    EXPECT_EQ(split.validation.size(), 2u);
    EXPECT_EQ(split.training.size(), 34u);
    EXPECT_NE(make_split(data, 2).test, split.test);
    write_split(folder / "split.json", split);
    const SubjectSplit read = read_split(folder / "split.json");
    EXPECT_EQ(read.training, split.training);
    EXPECT_EQ(read.test, split.test);
    for (const char* text :
         {"{}", "{\"training\":[1],\"test\":[1]}", "{\"training\":[1.5],\"test\":[2]}"}) {
        testing::write_bytes(folder / "bad.json", text);
        EXPECT_THROW(read_split(folder / "bad.json"), Error) << text;
    }
    decimate_dataset(data, 30, folder / "coarse.safetensors", {});
    const FaceDataset coarse = FaceDataset::open(folder / "coarse.safetensors", {}, {});
    EXPECT_EQ(coarse.num_vertices(), 30);
    EXPECT_EQ(coarse.num_faces(), data.num_faces());
    const PreparedFaces faces =
        prepare_faces(data, split, true, FeatureKind::euclidean, FeatureSpread::per_channel, {});
    EXPECT_EQ(faces.training.faces, 34);
    EXPECT_EQ(faces.validation.faces, 2);
}

TEST(Configuration, BuildsOnOthersAndRefusesWhatDoesNotExist) {
    const testing::ScratchFolder folder;
    std::filesystem::create_directories(folder / "model");
    testing::write_bytes(folder / "model/small.json", R"({"operator": "feastnet", "latent": 8})");
    testing::write_bytes(folder / "data.json", R"({"faces": "f.safetensors", "split": "s.json"})");
    const auto plan_of = [&](const std::string& text, std::vector<std::string> overrides = {}) {
        testing::write_bytes(folder / "plan.json", text);
        return read_plan(folder / "plan.json", overrides);
    };
    const std::string head = R"({"out": "o", "data": "data.json", )";
    Plan plan = plan_of(head + R"("model": {"base": "model/small.json", "matrices": 4}})",
                        {"experiment.epochs=7", "model.latent=9", "out=elsewhere"});
    ASSERT_EQ(plan.configurations.size(), 1u);
    const Configuration& c = plan.configurations[0];
    EXPECT_EQ(c.model.op, NetworkOperator::feastnet);
    EXPECT_EQ(c.model.matrices, 4);
    EXPECT_EQ(c.model.latent, 9);
    EXPECT_EQ(c.training.epochs, 7);
    EXPECT_EQ(plan.out, "elsewhere");
    EXPECT_EQ(c.data.faces, folder / "f.safetensors");
    plan = plan_of(head + R"("models": ["model/small.json", {"operator": "pca"}], "representations":
        [{"kind": "euclidean"}, {"kind": "deformation"}]})",
                   {"model.latent=5"});
    ASSERT_EQ(plan.configurations.size(), 4u);
    EXPECT_EQ(plan.configurations[1].name, "feastnet-deformation");
    EXPECT_EQ(plan.configurations[3].model.latent, 5);
    // A path given by hand was kept as text, and the parser's own exception came out.
    plan = plan_of(head + R"("model": {"operator": "pca"}})",
                   {"model.latent=6", "model=model/small.json"});
    EXPECT_EQ(plan.configurations[0].model.op, NetworkOperator::feastnet);
    EXPECT_EQ(plan.configurations[0].model.latent, 6);
    plan = plan_of(head + R"("model": {}})", {R"(models=["model/small.json"])"});
    EXPECT_EQ(plan.configurations[0].model.latent, 8);
    for (const char* wrong :
         {R"("models": "model/small.json"})", R"("model": {"depth": 3}})",
          R"("experiment": {"epochs": "many"}})", R"("model": {"operator": "transformer"}})",
          R"("representation": {"kind": "voxels"}})", R"("extra": 1})",
          R"("representations": [{}, {}]})"})
        EXPECT_THROW(plan_of(head + wrong), Error) << wrong;
}

}  // namespace
}  // namespace mien::training
