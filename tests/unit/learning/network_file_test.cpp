// Network files: whole round trips, and files that lie.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "unit/learning/network_support.hpp"
#include "unit/scratch.hpp"

namespace mien {
namespace {

using namespace test;

std::string status_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        return std::to_string(static_cast<int>(error.status())) + " " + error.what();
    }
    return "nothing";
}
bool is_refused(const std::function<void()>& work, Status status) {
    const std::string found = status_of(work);
    if (found.rfind(std::to_string(static_cast<int>(status)) + " ", 0) == 0) return true;
    ADD_FAILURE() << found;
    return false;
}

TEST(NetworkFile, KeepsEveryNumberOfEveryOperator) {
    const testing::ScratchFolder folder;
    const TriMesh mesh = face_like(14);
    const Points face = bent(mesh.vertices, 2);
    for (const NetworkOperator op : kAllOperators)
        for (const FeatureKind kind :
             {FeatureKind::euclidean_standardised, FeatureKind::deformation_normalised}) {
            const auto network = small_network(mesh, op, kind);
            const std::string path = folder / "network.safetensors";
            network->save(path, {});
            const auto read = Network::load(path, {}, {});
            EXPECT_EQ(read->encode(face, nullptr, {}), network->encode(face, nullptr, {}));
            EXPECT_EQ(read->apply(face, {}), network->apply(face, {}));
            EXPECT_EQ(read->json(), network->json());
            EXPECT_EQ(read->origin().name, network_operator_name(op));
        }
}

TEST(NetworkFile, AppliesInTheFrameOfTheFace) {
    const TriMesh mesh = face_like(14);
    for (const FeatureKind kind : {FeatureKind::euclidean, FeatureKind::deformation}) {
        const auto network = small_network(mesh, NetworkOperator::spiralnet, kind);
        Similarity away;
        away.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
        away.translation << 300, -20, 70;
        const Points face = bent(mesh.vertices, 1);
        const Points here = network->apply(face, {}), there = network->apply(away.apply(face), {});
        EXPECT_LT((away.apply(here) - there).cwiseAbs().maxCoeff(), 2e-3);
    }
}

TEST(NetworkFile, TheHalvesStandAlone) {
    const TriMesh mesh = face_like(14);
    const auto whole = small_network(mesh, NetworkOperator::spiralnet, FeatureKind::euclidean);
    auto features =
        FaceFeatures::train(mesh.triangles, face_source(mesh, 6), FeatureKind::euclidean, {});
    NetworkLayers layers = whole->layers();
    layers.decoder.clear();
    const auto encoder = Network::make(layers, features, nullptr, {}, {});
    EXPECT_EQ(encoder->code_size(), whole->code_size());
    EXPECT_TRUE(is_refused([&] { encoder->decode(Eigen::VectorXf::Zero(24), nullptr, {}); },
                           Status::unsupported_option));
    EXPECT_TRUE(is_refused([&] { encoder->apply(mesh.vertices, {}); }, Status::unsupported_option));
    EXPECT_TRUE(is_refused([&] { whole->decode(Eigen::VectorXf::Zero(7), nullptr, {}); },
                           Status::mismatch));
    EXPECT_TRUE(is_refused([&] { whole->encode(mesh.vertices.topRows(9), nullptr, {}); },
                           Status::mismatch));
}

TEST(NetworkFile, SaysWhatItIsInstead) {
    const testing::ScratchFolder folder;
    const TriMesh mesh = face_like(8);
    FaceFeatures::train(mesh.triangles, face_source(mesh, 3), FeatureKind::euclidean, {})
        ->save(folder / "features.safetensors", {});
    EXPECT_TRUE(is_refused([&] { Network::load(folder / "features.safetensors", {}, {}); },
                           Status::wrong_kind));
}

/// A copy with one tensor replaced.
NetworkLayers with_tensor(NetworkLayers layers, const std::string& name, NetworkTensor tensor) {
    layers.tensors.at(name) = std::move(tensor);
    return layers;
}

TEST(NetworkFile, RefusesListsThatLeaveTheMesh) {
    for (const NetworkOperator op : kAllOperators) {
        NetworkOptions options;
        options.op = op;
        const NetworkLayers good = build_network(face_like(14), options, {});
        for (const auto& [name, tensor] : good.tensors) {
            if (tensor.dtype != DType::u32) continue;
            for (const std::uint32_t lie : {0xffffffffu, 100000u}) {
                std::vector<std::uint32_t> values(tensor.numbers(),
                                                  tensor.numbers() + tensor.count());
                values[values.size() / 2] = lie;
                const NetworkLayers bad =
                    with_tensor(good, name, make_tensor(tensor.shape, std::move(values)));
                EXPECT_TRUE(is_refused([&] { check_layers(bad); }, Status::bad_format)) << name;
            }
        }
    }
}

TEST(NetworkFile, RefusesTensorsOfAnotherShapeOrType) {
    for (const NetworkOperator op : kAllOperators) {
        NetworkOptions options;
        options.op = op;
        const NetworkLayers good = build_network(face_like(14), options, {});
        for (const auto& [name, tensor] : good.tensors) {
            std::vector<std::uint64_t> longer = tensor.shape;
            longer.back() += 1;
            std::uint64_t count = 1;
            for (const std::uint64_t size : longer) count *= size;
            const auto size = static_cast<std::size_t>(count);
            const NetworkLayers bad = with_tensor(
                good, name,
                tensor.dtype == DType::f32 ? make_tensor(longer, std::vector<float>(size, 0.1f))
                                           : make_tensor(longer, std::vector<std::uint32_t>(size)));
            EXPECT_TRUE(is_refused([&] { check_layers(bad); }, Status::bad_format)) << name;
            NetworkTensor other = tensor;
            other.dtype = tensor.dtype == DType::f32 ? DType::u32 : DType::f32;
            EXPECT_TRUE(is_refused([&] { check_layers(with_tensor(good, name, other)); },
                                   Status::bad_format))
                << name;
            NetworkLayers without = good;
            without.tensors.erase(name);
            EXPECT_TRUE(is_refused([&] { check_layers(without); }, Status::bad_format)) << name;
        }
    }
}

TEST(NetworkFile, RefusesSizesThatDoNotFitOrAreNoFace) {
    const NetworkLayers good = build_network(face_like(14), {}, {});
    const auto refused = [&](const std::function<void(NetworkLayers&)>& change) {
        NetworkLayers bad = good;
        change(bad);
        return is_refused([&] { check_layers(bad); }, Status::bad_format);
    };
    EXPECT_TRUE(refused([](NetworkLayers& n) { n.encoder.erase(n.encoder.begin() + 1); }));
    EXPECT_TRUE(refused([](NetworkLayers& n) { n.encoder.front().channels_in += 1; }));
    EXPECT_TRUE(refused([](NetworkLayers& n) { n.encoder.front().channels_in = 1 << 30; }));
    EXPECT_TRUE(refused([](NetworkLayers& n) { n.decoder.front().rows_in = 0; }));
    EXPECT_TRUE(refused([](NetworkLayers& n) { n.encoder.front().residual_rate = 2; }));
    EXPECT_TRUE(
        refused([](NetworkLayers& n) { n.encoder.front().tensors["more"] = "up.0.value"; }));
    EXPECT_TRUE(refused([](NetworkLayers& n) { n.encoder.clear(), n.decoder.clear(); }));
    EXPECT_TRUE(refused([](NetworkLayers& n) { n.decoder.erase(n.decoder.begin()); }));
}

TEST(NetworkFile, RefusesASmallFileThatAsksForMuchMemory) {
    NetworkOptions options;
    options.op = NetworkOperator::feastnet;
    NetworkLayers network = build_network(face_like(14), options, {});
    network.encoder.front().rows_in = Index(1) << 24;  // its lists name the first rows alone
    EXPECT_TRUE(is_refused([&] { check_layers(network); }, Status::bad_format));
    // The same of a layer that needs no room of its own: it does not fit the features.
    const TriMesh mesh = face_like(14);
    auto features =
        FaceFeatures::train(mesh.triangles, face_source(mesh, 3), FeatureKind::euclidean, {});
    NetworkLayers wide = build_network(mesh, {}, {});
    wide.encoder.front().rows_in = Index(1) << 24;
    EXPECT_TRUE(
        is_refused([&] { Network::make(wide, features, nullptr, {}, {}); }, Status::bad_format));
}

TEST(NetworkFile, ReadsNoLayerThatItDoesNotKnow) {
    NetworkLayers layers;
    for (const char* text :
         {"", "[", "{\"encoder\":5}", "{\"encoder\":[{\"kind\":\"attention\"}]}",
          "{\"encoder\":[{\"kind\":\"elu\",\"rows_in\":-3}]}",
          "{\"encoder\":[{\"kind\":\"elu\",\"rows_in\":1e300,\"channels_in\":1,\"rows_out\":1,"
          "\"channels_out\":1}]}"})
        EXPECT_TRUE(is_refused([&] { read_layers_json(text, layers); }, Status::bad_format))
            << text;
    const NetworkLayers good = build_network(face_like(8), {}, {});
    read_layers_json(layers_json(good), layers);
    EXPECT_EQ(layers_json(layers), layers_json(good));
}

TEST(NetworkFile, EveryTruncationIsATypedError) {
    const testing::ScratchFolder folder;
    const std::string path = folder / "network.safetensors";
    small_network(face_like(8), NetworkOperator::feastnet, FeatureKind::euclidean)->save(path, {});
    const std::string bytes = testing::read_bytes(path);
    for (std::size_t k = 0; k < 60; ++k) {
        testing::write_bytes(path, bytes.substr(0, bytes.size() * k / 60));
        EXPECT_NE(status_of([&] { Network::load(path, {}, {}); }), "nothing") << k;
    }
}

}  // namespace
}  // namespace mien
