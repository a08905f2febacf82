#include "training/runner.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "base/file.hpp"
#include "learning/network.hpp"
#include "learning/network_evaluation.hpp"
#include "training/faces.hpp"

namespace mien::training {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

void write_text(const fs::path& path, const std::string& text) {
    AtomicFile file(path.u8string());
    file.write(text);
    file.commit();
}

Json errors_of(const ReconstructionErrors& errors, double scale_mm) {
    const double l1 = ReconstructionErrors::mean(errors.l1_mm);
    // As kosk-2024 prints it: mean over the coordinates, of faces scaled into [-1, 1].
    return {{"faces", errors.l1_mm.size()},
            {"l1_mm", l1},
            {"l2_mm", ReconstructionErrors::mean(errors.l2_mm)},
            {"l1_scaled", l1 / 3 / scale_mm},
            {"dame", ReconstructionErrors::mean(errors.dame)},
            {"fmpd", ReconstructionErrors::mean(errors.fmpd)}};
}

std::string minutes(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f:%02.0f", std::floor(seconds / 60),
                  std::floor(std::fmod(seconds, 60)));
    return text;
}

struct Evaluated {
    const FaceDataset& data;
    const DataChoice& choice;
    const SubjectSplit& split;

    Json errors(const Network& network, const std::vector<std::int32_t>& people) const {
        const auto reconstruct = [&](const Points& face) { return network.apply(face, {}); };
        return errors_of(reconstruction_errors(data, chosen_faces(data, people, choice.neutral),
                                               reconstruct, true, {}),
                         network.input().scale_mm());
    }
};

/// Trains and gives what the row says about it; the two networks come back by reference.
Json train_layers(const Configuration& c, const PreparedFaces& faces, const std::string& state,
                  const std::atomic<bool>& stop, NetworkLayers& last, NetworkLayers& best) {
    NetworkOptions options = c.model;
    options.channels_in = options.channels_out = faces.features->num_channels();
    const NetworkLayers initial = build_network(faces.features->mean(), options, {});
    const auto say = [&](const EpochRecord& record, double left) {
        std::fprintf(stderr, "%s: epoch %d of %d, loss %.6f", c.name.c_str(), record.epoch,
                     c.training.epochs, record.training_loss);
        if (record.validation_loss >= 0)
            std::fprintf(stderr, ", validation %.6f", record.validation_loss);
        std::fprintf(stderr, ", %.1f s, %s left\n", record.seconds, minutes(left).c_str());
    };
    TrainingResult result =
        train(initial, faces.training, faces.validation, c.training, state, say, stop);
    if (!result.finished) return nullptr;
    Json losses = Json::array();
    double seconds = 0;
    for (const EpochRecord& record : result.epochs) {
        losses.push_back({record.training_loss, record.validation_loss});
        seconds += record.seconds;
    }
    last = std::move(result.last);
    best = std::move(result.best);
    for (NetworkLayers* layers : {&last, &best}) {  // the variance has served
        for (const NetworkLayer& layer : layers->variance)
            for (const auto& entry : layer.tensors)
                if (is_trained_role(layer.kind, entry.first)) layers->tensors.erase(entry.second);
        layers->variance.clear();
    }
    return {{"epochs", c.training.epochs},
            {"best_epoch", result.best_epoch},
            {"seconds", seconds},
            {"losses", losses}};
}

}  // namespace

Configuration pca_of(const Configuration& configuration) {
    Configuration pca = configuration;
    pca.pca = true;
    pca.name = "pca-euclidean";
    pca.representation = FeatureKind::euclidean;
    pca.spread = FeatureSpread::per_vertex;
    pca.text["model"] = {{"operator", "pca"}, {"latent", configuration.model.latent}};
    pca.text["representation"] = {{"kind", "euclidean"}};
    pca.text["experiment"] = Json::object();
    return pca;
}

Json run_configuration(const Configuration& c, const std::string& folder,
                       const std::atomic<bool>& stop) {
    const fs::path room = fs::u8path(folder) / fs::u8path(c.name);
    fs::create_directories(room);
    const fs::path result_path = room / "result.json";
    if (fs::exists(result_path)) {
        std::ifstream in(result_path);
        Json row = Json::parse(in, nullptr, false);
        if (!row.is_discarded() && row.value("configuration", Json()) == c.text) return row;
    }
    const FaceDataset data = FaceDataset::open(c.data.faces, {}, {});
    const SubjectSplit split = read_split(c.data.split);
    const PreparedFaces faces =
        prepare_faces(data, split, c.data.neutral, c.representation, c.spread, {});
    NetworkLayers last, best;
    Json training = Json::object();
    if (c.pca) {
        last = best = pca_network(faces.training, c.model.latent);
    } else {
        training =
            train_layers(c, faces, (room / "state.safetensors").u8string(), stop, last, best);
        if (training.is_null()) return nullptr;
    }
    const NetworkOrigin origin{c.pca ? "pca" : c.name, c.text.dump()};
    const auto network = Network::make(std::move(last), faces.features, nullptr, origin, {});
    const auto best_network = Network::make(std::move(best), faces.features, nullptr, origin, {});
    network->save((room / "network.safetensors").u8string(), {});
    best_network->save((room / "best.safetensors").u8string(), {});
    const Evaluated evaluated{data, c.data, split};
    Json row = {{"name", c.name},
                {"model", c.pca ? "pca" : network_operator_name(c.model.op)},
                {"representation", feature_kind_name(c.representation)},
                {"spread", c.spread == FeatureSpread::per_vertex ? "per_vertex" : "per_channel"},
                {"code", network->code_size()},
                {"weights", network->num_weights()},
                {"scale_mm", faces.features->scale_mm()},
                {"training", evaluated.errors(*network, split.training)},
                {"test", evaluated.errors(*network, split.test)},
                {"test_best", evaluated.errors(*best_network, split.test)},
                {"run", training},
                {"configuration", c.text}};
    write_text(result_path, row.dump(1) + "\n");
    return row;
}

}  // namespace mien::training
