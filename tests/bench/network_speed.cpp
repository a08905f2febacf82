// Milliseconds of one face through the five networks, on one thread: network_speed MESH [LATENT]
// [ROUNDS]. Untrained weights: the time does not depend on them. Medians of processor time, with
// the AVX2 loops and the portable ones.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/random.hpp"
#include "learning/band_network.hpp"
#include "learning/network.hpp"
#include "learning/network_builder.hpp"
#include "mesh/mesh_file.hpp"
#include "spectral_support.hpp"

using namespace mien;

namespace {

template <typename Work>
double median_ms(int rounds, const Work& work) {
    std::vector<double> times;
    for (int k = 0; k < rounds; ++k) {
        const double begin = bench::cpu_seconds();
        work();
        times.push_back(1e3 * (bench::cpu_seconds() - begin));
    }
    std::nth_element(times.begin(), times.begin() + rounds / 2, times.end());
    return times[static_cast<std::size_t>(rounds / 2)];
}

void measure(const TriMesh& mesh, NetworkOperator op, Index latent, int rounds) {
    FaceSource source;
    source.count = 3;
    source.face = [&](Index k, Points& face) {
        face = mesh.vertices * (1 + 0.01 * static_cast<double>(k));
    };
    const auto features =
        FaceFeatures::train(mesh.triangles, source, FeatureKind::euclidean_standardised, {});
    NetworkOptions options;
    options.op = op;
    options.latent = latent;
    options.variational = false;
    const auto network = Network::make(build_network(features->mean(), options, {}), features,
                                       nullptr, {network_operator_name(op), ""}, {});
    const std::string path = "/tmp/mien_network_speed.safetensors";
    network->save(path, {});
    SafetensorsReadOptions quick;
    quick.verify_hash = quick.verify_finite = false;
    const double load_ms = median_ms(5, [&] { Network::load(path, quick, {}); });
    std::remove(path.c_str());

    std::vector<float> face(static_cast<std::size_t>(mesh.vertices.rows() * 3)),
        code(static_cast<std::size_t>(network->code_size()));
    const CounterRandom chance(1, 1);
    for (std::size_t k = 0; k < face.size(); ++k) face[k] = static_cast<float>(chance.normal(k));
    double encode[2], decode[2], apply = 0;
    for (const bool portable : {false, true}) {
        dense::use_portable_loops(portable);
        encode[portable] =
            median_ms(rounds, [&] { network->encode_features(face.data(), code.data(), {}); });
        decode[portable] =
            median_ms(rounds, [&] { network->decode_features(code.data(), face.data(), {}); });
        if (!portable) apply = median_ms(rounds, [&] { network->apply(mesh.vertices, {}); });
    }
    dense::use_portable_loops(false);
    std::printf("%-17s %5lld %8.2f M %6.0f M %8.2f %8.2f %8.2f %8.2f %10.2f %8.2f\n",
                network_operator_name(op), static_cast<long long>(network->code_size()),
                1e-6 * static_cast<double>(network->num_weights()),
                1e-6 * (network->encoder_products() + network->decoder_products()), encode[0],
                decode[0], encode[1], decode[1], apply, load_ms);
}

/// Two bands at 500 modes: a face to its code, back, and both with the alignment.
void measure_bands(const TriMesh& mesh, Index latent, int rounds) {
    FaceSource source;
    source.count = 3;
    const CounterRandom chance(2, 2);
    source.face = [&](Index k, Points& face) {
        face = mesh.vertices * (1 + 0.01 * static_cast<double>(k));
        for (Index i = 0; i < face.size(); ++i)
            face.data()[i] += 0.1 * chance.normal(static_cast<std::uint64_t>(k * face.size() + i));
    };
    const auto features = BandFeatures::train(mesh.triangles, source, {}, {});
    const auto part = [&](const std::shared_ptr<const FaceFeatures>& of) {
        NetworkOptions options;
        options.op = NetworkOperator::mesh_autoencoder;
        options.channels_in = options.channels_out = of->num_channels();
        options.latent = latent / 2;
        options.conditioned = true;
        options.variational = false;
        return Network::make(build_network(features->mean(), options, {}), of, nullptr, {}, {});
    };
    const auto network =
        BandNetwork::make({part(features->shared_low()), part(features->shared_high()),
                           features->basis(), BandTask::faces, features->band_limit(), 1},
                          {});
    Similarity motion;
    Eigen::VectorXf code = network->encode(mesh.vertices, &motion, {});
    const double encode =
        median_ms(rounds, [&] { code = network->encode(mesh.vertices, &motion, {}); });
    const double decode = median_ms(rounds, [&] { network->decode(code, &motion, {}); });
    const double joining = median_ms(rounds, [&] {
        assemble(network->basis(), mesh.vertices, mesh.vertices, network->band_limit(), {});
    });
    std::printf(
        "two bands of mesh-autoencoder, k = %lld, %lld numbers: face to code %.1f, code to "
        "face %.1f (assembly alone %.1f), face to face %.1f ms\n",
        static_cast<long long>(network->band_limit()), static_cast<long long>(network->code_size()),
        encode, decode, joining, encode + decode);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: network_speed MESH [LATENT] [ROUNDS]\n");
        return 2;
    }
    try {
        TriMesh mesh = read_mesh_file(argv[1], {});
        const Index latent = argc > 2 ? std::atoll(argv[2]) : 64;
        const int rounds = argc > 3 ? std::atoi(argv[3]) : 15;
        std::printf("%lld vertices, %s loops; ms of processor time, one thread\n",
                    static_cast<long long>(mesh.vertices.rows()),
                    dense::uses_avx2() ? "AVX2" : "portable");
        std::printf("%-17s %5s %10s %8s %8s %8s %8s %8s %10s %8s\n", "", "code", "weights",
                    "products", "encode", "decode", "portable", "portable", "face-face", "load");
        for (const NetworkOperator op :
             {NetworkOperator::feastnet, NetworkOperator::neural3dmm, NetworkOperator::spiralnet,
              NetworkOperator::mesh_autoencoder, NetworkOperator::lsa3dmm})
            measure(mesh, op, latent, rounds);
        measure_bands(mesh, latent, rounds);
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "network_speed: %s\n", failure.what());
        return 1;
    }
    return 0;
}
