// Autoencoders of faces: one network, two over the bands, or principal components.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"
#include "geometry/alignment.hpp"
#include "learning/band_network.hpp"
#include "spectral/metrics.hpp"
#include "training/runs.hpp"

namespace mien::training {
namespace {

using Json = nlohmann::json;

std::string minutes(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f:%02.0f", std::floor(seconds / 60),
                  std::floor(std::fmod(seconds, 60)));
    return text;
}

EpochListener listener_of(const Configuration& c) {
    return [&c](const EpochRecord& record, double left) {
        std::fprintf(stderr, "%s: epoch %d of %d, loss %.6f", c.name.c_str(), record.epoch,
                     c.training.epochs, record.training_loss);
        if (record.high_training_loss > 0)
            std::fprintf(stderr, " + %.6f", record.high_training_loss);
        if (record.validation_loss >= 0)
            std::fprintf(stderr, ", validation %.6f", record.validation_loss);
        if (record.high_validation_loss >= 0)
            std::fprintf(stderr, " + %.6f", record.high_validation_loss);
        std::fprintf(stderr, ", %.1f s, %s left\n", record.seconds, minutes(left).c_str());
    };
}

Json run_json(const TrainingResult& result, int epochs) {
    Json losses = Json::array();
    double seconds = 0;
    for (const EpochRecord& record : result.epochs) {
        losses.push_back({record.training_loss, record.validation_loss});
        if (record.high_training_loss > 0) {
            losses.back().push_back(record.high_training_loss);
            losses.back().push_back(record.high_validation_loss);
        }
        seconds += record.seconds;
    }
    return {{"epochs", epochs},
            {"best_epoch", result.best_epoch},
            {"seconds", seconds},
            {"losses", losses}};
}

/// The variance has served.
NetworkLayers finished_layers(NetworkLayers layers) {
    for (const NetworkLayer& layer : layers.variance)
        for (const auto& entry : layer.tensors)
            if (is_trained_role(layer.kind, entry.first)) layers.tensors.erase(entry.second);
    layers.variance.clear();
    return layers;
}

/// make(codes) with the distribution of the training faces' codes.
template <typename Make>
std::shared_ptr<const FaceNetwork> with_codes(const RunContext& context, const Make& make) {
    const auto plain = make(CodeDistribution{});
    const std::vector<Index> faces =
        chosen_faces(context.data, context.split.training, context.configuration.data.neutral);
    if (faces.size() < 2) return plain;
    Matrix codes(plain->code_size(), static_cast<Index>(faces.size()));
    Points face;
    for (Index k = 0; k < codes.cols(); ++k) {
        context.data.face(faces[static_cast<std::size_t>(k)], face);
        codes.col(k) = plain->encode(face, nullptr, {}).template cast<double>();
    }
    return make(code_distribution(codes));
}

MadeNetworks make_bands(const RunContext& context, const NetworkOrigin& origin) {
    const Configuration& c = context.configuration;
    BandFeatureOptions bands;
    bands.band_limit = c.band_limit;
    bands.low_kind = c.low_kind;
    bands.high_kind = c.high_kind;
    bands.spread = c.spread;
    const PreparedBands faces =
        prepare_bands(context.data, context.split, c.data.neutral, bands, {});
    const auto layers_of = [&](const FaceFeatures& features, std::uint64_t seed) {
        NetworkOptions options = c.model;
        options.channels_in = options.channels_out = features.num_channels();
        options.latent = std::max<Index>(1, c.model.latent / 2);  // of both together: latent
        options.conditioned = true;
        options.seed = seed;
        return build_network(faces.features->mean(), options, {});
    };
    const NetworkLayers low = layers_of(faces.features->low(), c.model.seed);
    const NetworkLayers high = layers_of(faces.features->high(), c.model.seed + 1);
    TrainingResult result =
        train_bands({low, faces.low_training, faces.low_validation},
                    {high, faces.high_training, faces.high_validation}, c.training,
                    context.room + "state.safetensors", listener_of(c), context.stop);
    if (!result.finished) return {};
    const auto joined = [&](const NetworkLayers& of_low, const NetworkLayers& of_high) {
        const auto part = [&](const NetworkLayers& layers,
                              const std::shared_ptr<const FaceFeatures>& features,
                              const char* name) {
            return Network::make(finished_layers(layers), features, nullptr, {name, ""}, {});
        };
        BandNetwork::Parts parts{part(of_low, faces.features->shared_low(), "low band"),
                                 part(of_high, faces.features->shared_high(), "high band"),
                                 faces.features->basis(),
                                 BandTask::faces,
                                 c.band_limit,
                                 c.training.conditioning};
        return with_codes(context, [&](CodeDistribution codes) {
            return BandNetwork::make(parts, origin, std::move(codes));
        });
    };
    return {joined(result.last, result.high_last), joined(result.best, result.high_best),
            run_json(result, c.training.epochs)};
}

}  // namespace

Json train_single(const RunContext& context, const NetworkLayers& initial,
                  const TrainingData& training, const TrainingData& validation,
                  const TrainingSettings& settings, NetworkLayers& last, NetworkLayers& best) {
    TrainingResult result =
        train(initial, training, validation, settings, context.room + "state.safetensors",
              listener_of(context.configuration), context.stop);
    if (!result.finished) return nullptr;
    last = finished_layers(std::move(result.last));
    best = finished_layers(std::move(result.best));
    return run_json(result, settings.epochs);
}

MadeNetworks make_face_networks(const RunContext& context) {
    const Configuration& c = context.configuration;
    const NetworkOrigin origin{c.pca ? "pca" : c.name, c.text.dump()};
    if (c.bands) return make_bands(context, origin);
    const PreparedFaces faces =
        prepare_faces(context.data, context.split, c.data.neutral, c.representation, c.spread, {});
    MadeNetworks made;
    made.run = Json::object();
    NetworkLayers last, best;
    if (c.pca) {
        last = best = pca_network(faces.training, c.model.latent);
    } else {
        NetworkOptions options = c.model;
        options.channels_in = options.channels_out = faces.features->num_channels();
        made.run = train_single(context, build_network(faces.features->mean(), options, {}),
                                faces.training, faces.validation, c.training, last, best);
        if (made.run.is_null()) return {};
    }
    const auto network_of = [&](const NetworkLayers& layers) {
        return with_codes(context,
                          [&](CodeDistribution codes) -> std::shared_ptr<const FaceNetwork> {
                              return Network::make(layers, faces.features, nullptr, origin, {},
                                                   NetworkTask::face, std::move(codes));
                          });
    };
    made.last = network_of(last);
    made.best = network_of(best);
    return made;
}

Json band_measures(const FaceNetwork& network, const FaceDataset& data,
                   const std::vector<Index>& faces) {
    const auto& bands = dynamic_cast<const BandNetwork&>(network);
    const std::size_t pairs = std::min<std::size_t>(faces.size() / 2, 10);
    double low_by_low = 0, high_by_low = 0, low_by_high = 0, high_by_high = 0;
    double rough_network = 0, rough_coordinates = 0;
    TriMesh mesh;
    mesh.triangles = data.triangles();
    const auto roughness = [&](const Points& face) {
        mesh.vertices = face;
        return local_roughness(mesh, {}).mean();
    };
    Points a, b;
    for (std::size_t k = 0; k < pairs; ++k) {
        data.face(faces[2 * k], a);
        data.face(faces[2 * k + 1], b);
        b = align_points(b, a, {}, false).apply(b);
        // Of b's frame nothing is left: codes know no motion.
        const auto parts = [&](double low, double high) {
            Similarity motion;
            onto_mean_shape(a, network.mean(), &motion);
            const Points face = motion.apply(network.mix(a, b, low, high, {}));
            return std::make_pair(low_band(bands.basis(), face, bands.band_limit(), {}),
                                  high_band(bands.basis(), face, bands.band_limit(), {}));
        };
        const auto same = parts(0, 0), by_low = parts(1, 0), by_high = parts(0, 1);
        low_by_low += l2_distance(same.first, by_low.first);
        high_by_low += l2_distance(same.second, by_low.second);
        low_by_high += l2_distance(same.first, by_high.first);
        high_by_high += l2_distance(same.second, by_high.second);
        const double parents =
            0.5 * (roughness(network.apply(a, {})) + roughness(network.apply(b, {})));
        rough_network += roughness(network.mix(a, b, 0.5, 0.5, {})) / parents;
        rough_coordinates +=
            roughness(0.5 * (network.apply(a, {}) + network.apply(b, {}))) / parents;
    }
    if (pairs == 0) return nullptr;
    const auto n = static_cast<double>(pairs);
    return {{"pairs", pairs},
            {"low_edit_moves_low_mm", low_by_low / n},
            {"low_edit_moves_high_mm", high_by_low / n},
            {"high_edit_moves_low_mm", low_by_high / n},
            {"high_edit_moves_high_mm", high_by_high / n},
            {"halfway_roughness_network", rough_network / n},
            {"halfway_roughness_coordinates", rough_coordinates / n}};
}

}  // namespace mien::training
