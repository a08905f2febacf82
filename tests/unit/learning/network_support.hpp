// Random layers and small networks for the tests of the evaluator.
#pragma once

#include "base/random.hpp"
#include "learning/band_network.hpp"
#include "learning/displacement_features.hpp"
#include "learning/network.hpp"
#include "learning/network_builder.hpp"
#include "unit/spectral/shapes.hpp"

namespace mien::test {

/// Adds random tensors to a network under construction.
class RandomTensors {
  public:
    RandomTensors(NetworkLayers& network, std::uint64_t seed)
        : network_(network), chance_(seed, 1) {}

    void floats(NetworkLayer& layer, const std::string& role, std::vector<std::uint64_t> shape,
                double deviation) {
        std::uint64_t count = 1;
        for (const std::uint64_t size : shape) count *= size;
        std::vector<float> values;
        for (std::uint64_t k = 0; k < count; ++k)
            values.push_back(static_cast<float>(deviation * chance_.normal(next_++)));
        add(layer, role, make_tensor(std::move(shape), std::move(values)));
    }
    /// Numbers of 0 to limit - 1.
    void numbers(NetworkLayer& layer, const std::string& role, std::vector<std::uint64_t> shape,
                 Index limit) {
        std::uint64_t count = 1;
        for (const std::uint64_t size : shape) count *= size;
        std::vector<std::uint32_t> values;
        for (std::uint64_t k = 0; k < count; ++k) values.push_back(number(limit));
        add(layer, role, make_tensor(std::move(shape), std::move(values)));
    }
    /// "begin" and "neighbour" with 1 to `most` entries a row; gives the number of entries.
    std::uint64_t rows(NetworkLayer& layer, Index most) {
        std::vector<std::uint32_t> begin{0}, neighbour;
        for (Index i = 0; i < layer.rows_out; ++i) {
            const std::uint32_t count = 1 + number(most);
            for (std::uint32_t k = 0; k < count; ++k) neighbour.push_back(number(layer.rows_in));
            begin.push_back(static_cast<std::uint32_t>(neighbour.size()));
        }
        const std::uint64_t entries = neighbour.size();
        add(layer, "begin",
            make_tensor({static_cast<std::uint64_t>(layer.rows_out) + 1}, std::move(begin)));
        add(layer, "neighbour", make_tensor({entries}, std::move(neighbour)));
        return entries;
    }

  private:
    std::uint32_t number(Index limit) {
        return static_cast<std::uint32_t>(chance_.uniform(next_++) * static_cast<double>(limit));
    }
    void add(NetworkLayer& layer, const std::string& role, NetworkTensor tensor) {
        const std::string name = role + std::to_string(network_.tensors.size());
        network_.tensors[name] = std::move(tensor);
        layer.tensors[role] = name;
    }
    NetworkLayers& network_;
    CounterRandom chance_;
    std::uint64_t next_ = 0;
};

/// One random layer of a kind; `variant` switches what is optional.
inline NetworkLayers random_layer(LayerKind kind, Index rows_in, Index in, Index rows_out,
                                  Index out, bool elu, int variant, std::uint64_t seed) {
    NetworkLayers network;
    RandomTensors random(network, seed);
    NetworkLayer layer;
    layer.kind = kind;
    layer.rows_in = rows_in;
    layer.channels_in = in;
    layer.rows_out = rows_out;
    layer.channels_out = out;
    layer.elu = elu;
    const auto u = [](Index size) { return static_cast<std::uint64_t>(size); };
    const auto n = u(rows_out);
    const std::uint64_t places = 9, matrices = 9, bases = 7;
    switch (kind) {
        case LayerKind::gather:
            random.numbers(layer, "index", {n, places}, rows_in + 1);
            random.floats(layer, "weight", {places * u(in), u(out)}, 0.2);
            random.floats(layer, "bias", {u(out)}, 0.2);
            break;
        case LayerKind::steered:
            random.rows(layer, 8);
            random.numbers(layer, "centre", {n}, rows_in);
            // Variant 1: so steep that the shares of the two sides underflow.
            random.floats(layer, "steer", {u(in), matrices}, variant == 1 ? 60 : 0.5);
            random.floats(layer, "offset", {matrices}, 0.5);
            random.floats(layer, "weight", {matrices * u(in), u(out)}, 0.2);
            random.floats(layer, "bias", {u(out)}, 0.2);
            break;
        case LayerKind::basis: {
            const std::uint64_t entries = random.rows(layer, 8);
            layer.residual_rate = variant == 2 ? 0 : 0.5;
            random.floats(layer, "coefficient", {entries, bases}, 0.3);
            random.floats(layer, "weight", {bases * u(in), u(out)}, 0.3);
            random.floats(layer, "bias", {u(out)}, 0.2);
            if (variant != 1 || rows_in != rows_out)
                random.floats(layer, "density", {entries}, 0.5);
            if (variant != 1 || in != out) random.floats(layer, "shortcut", {u(in), u(out)}, 0.5);
            break;
        }
        case LayerKind::permuted:
            random.numbers(layer, "index", {n, places}, rows_in + 1);
            if (variant == 0) {
                random.floats(layer, "mixing", {n, places, places}, 0.4);
            } else {
                random.floats(layer, "mixing_weight", {n, 3}, 0.4);
                random.floats(layer, "mixing_basis", {3, places, places}, 0.4);
            }
            random.floats(layer, "weight", {places * u(in), u(out)}, 0.2);
            random.floats(layer, "bias", {u(out)}, 0.2);
            random.floats(layer, "shortcut", {u(in), u(out)}, 0.4);
            random.floats(layer, "shortcut_bias", {u(out)}, 0.2);
            break;
        case LayerKind::dense:
            random.floats(layer, "weight", {u(rows_in * in), n * u(out)}, 0.1);
            random.floats(layer, "bias", {n * u(out)}, 0.2);
            break;
        case LayerKind::pick:
            random.numbers(layer, "index", {n}, rows_in);
            break;
        case LayerKind::sparse:
            random.floats(layer, "value", {random.rows(layer, 3)}, 0.5);
            break;
        case LayerKind::elu:
            break;
        case LayerKind::affine:
            random.floats(layer, "scale", {variant == 0 ? n : 1, u(out)}, 1);
            random.floats(layer, "shift", {variant == 0 ? n : 1, u(out)}, 1);
            break;
    }
    network.encoder.push_back(layer);
    return network;
}

inline std::vector<float> random_input(std::size_t count, std::uint64_t seed,
                                       double deviation = 1) {
    const CounterRandom chance(seed, 2);
    std::vector<float> values;
    for (std::size_t k = 0; k < count; ++k)
        values.push_back(static_cast<float>(deviation * chance.normal(k)));
    return values;
}

/// Faces like a person's: a smooth template with a few random amplitudes.
inline FaceSource face_source(const TriMesh& mesh, Index count) {
    FaceSource source;
    source.count = count;
    source.face = [&mesh](Index k, Points& face) {
        face = bent(mesh.vertices, 3 * noise(static_cast<std::uint64_t>(k)));
        face = noisy(face, 0.3, static_cast<std::uint64_t>(1000 * k));
    };
    return source;
}

constexpr NetworkOperator kAllOperators[] = {
    NetworkOperator::feastnet, NetworkOperator::neural3dmm, NetworkOperator::spiralnet,
    NetworkOperator::mesh_autoencoder, NetworkOperator::lsa3dmm};

/// An untrained network over a template, with features of a few faces.
inline std::shared_ptr<const Network> small_network(const TriMesh& mesh, NetworkOperator op,
                                                    FeatureKind kind) {
    auto features = FaceFeatures::train(mesh.triangles, face_source(mesh, 6), kind, {});
    NetworkOptions options;
    options.op = op;
    options.channels_in = options.channels_out = features->num_channels();
    options.latent = 24;
    options.variational = false;
    NetworkLayers layers = build_network(features->mean(), options, {});
    return Network::make(std::move(layers), features, nullptr,
                         {network_operator_name(op), "{\"epochs\":0}"}, {});
}

/// Two untrained autoencoders over the bands of a template's faces.
inline std::shared_ptr<const BandNetwork> small_bands(const TriMesh& mesh, NetworkOperator op,
                                                      double conditioning = 1,
                                                      CodeDistribution codes = {}) {
    BandFeatureOptions bands;
    bands.band_limit = 12;
    const auto features = BandFeatures::train(mesh.triangles, face_source(mesh, 6), bands, {});
    const auto part = [&](const std::shared_ptr<const FaceFeatures>& of) {
        NetworkOptions options;
        options.op = op;
        options.channels_in = options.channels_out = of->num_channels();
        options.latent = 24;
        options.conditioned = true;
        options.variational = false;
        return Network::make(build_network(features->mean(), options, {}), of, nullptr,
                             {"part", ""}, {});
    };
    return BandNetwork::make({part(features->shared_low()), part(features->shared_high()),
                              features->basis(), BandTask::faces, 12, conditioning},
                             {"bands", "{\"epochs\":0}"}, std::move(codes));
}

/// Neutral faces and the same people with a bump.
inline FacePairs face_pairs(const TriMesh& mesh, Index count) {
    FacePairs pairs;
    pairs.count = count;
    pairs.pair = [&mesh, source = face_source(mesh, count)](Index k, Points& neutral,
                                                            Points& expression) {
        source.face(k, neutral);
        expression = neutral;
        const double strength = 2 + noise(static_cast<std::uint64_t>(500 + k));
        for (Index v = 0; v < neutral.rows(); ++v)
            expression(v, 2) += strength * std::exp(-neutral.row(v).squaredNorm() / 2000);
    };
    return pairs;
}

/// An untrained network from neutral faces to displacements of a kind.
inline std::shared_ptr<const Network> small_displacement(const TriMesh& mesh, FeatureKind kind) {
    const auto input = FaceFeatures::train(mesh.triangles, face_source(mesh, 6), kind, {});
    const auto output =
        train_displacements(*input, face_pairs(mesh, 6), kind, FeatureSpread::per_channel, {});
    NetworkOptions options;
    options.channels_in = input->num_channels();
    options.channels_out = output->num_channels();
    options.latent = 24;
    return Network::make(build_network(input->mean(), options, {}), input, output,
                         {"displacement", ""}, {}, NetworkTask::displacement);
}

inline std::shared_ptr<const BandNetwork> small_expression(const TriMesh& mesh, Index band_limit) {
    const auto low = small_displacement(mesh, FeatureKind::euclidean_standardised);
    const auto high = small_displacement(mesh, FeatureKind::deformation_normalised);
    SpectralBasisOptions options;
    options.num_modes = 20;
    return BandNetwork::make({low, high, build_spectral_basis(low->mean(), options, {}),
                              BandTask::expression, band_limit, 1},
                             {"grin", ""});
}

}  // namespace mien::test
