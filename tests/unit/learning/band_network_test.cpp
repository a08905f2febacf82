// Two networks over the bands of a face: assembly, conditioning, mixing, sampling, files that lie.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "unit/learning/network_support.hpp"
#include "unit/scratch.hpp"

namespace mien {
namespace {

using namespace test;

Status band_status(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.status();
    }
    return Status::ok;
}

Similarity turned_away() {
    Similarity away;
    away.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    away.translation << 300, -20, 70;
    return away;
}

double largest(const Points& a, const Points& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

TEST(BandFeatures, BothBandsOfOneFaceAreThatFaceTo1e4Millimetres) {
    const TriMesh mesh = face_like(20);
    for (const Index k : {1, 12, 60})
        for (const FeatureSpread spread : {FeatureSpread::per_vertex, FeatureSpread::per_channel}) {
            BandFeatureOptions options;
            options.band_limit = k;
            options.spread = spread;
            const auto bands =
                BandFeatures::train(mesh.triangles, face_source(mesh, 6), options, {});
            const Points face = turned_away().apply(noisy(bent(mesh.vertices, 2.5), 0.4, 77));
            Similarity motion;
            const BandFeatures::Pair pair = bands->encode(face, &motion, {});
            EXPECT_EQ(pair.low.cols(), 3);
            EXPECT_EQ(pair.high.cols(), 9);
            EXPECT_LT(largest(bands->decode(pair.low, pair.high, &motion, {}), face), 1e-4) << k;
        }
}

TEST(BandFeatures, RefusesBandsThatCannotBeJoined) {
    const TriMesh mesh = face_like(10);
    BandFeatureOptions options;
    options.band_limit = 8;
    options.low_kind = FeatureKind::deformation;
    const auto train = [&] {
        BandFeatures::train(mesh.triangles, face_source(mesh, 4), options, {});
    };
    EXPECT_EQ(band_status(train), Status::invalid_argument);
    options.low_kind = FeatureKind::euclidean;
    options.high_kind = FeatureKind::euclidean;
    EXPECT_EQ(band_status(train), Status::invalid_argument);
    options.high_kind = FeatureKind::deformation;
    options.band_limit = mesh.vertices.rows();
    EXPECT_EQ(band_status(train), Status::invalid_argument);
}

TEST(BandNetwork, MovesEachBandsCodeByItsOwnWeight) {
    const TriMesh mesh = face_like(16);
    const Points a = bent(mesh.vertices, 2), b = noisy(bent(mesh.vertices, -1), 0.5, 5);
    for (const NetworkOperator op : kAllOperators) {
        const auto network = small_bands(mesh, op);
        const Index low = network->low_code_size();
        EXPECT_EQ(low, network->high().code_size());
        EXPECT_EQ(network->mix(a, b, 0, 0, {}), network->apply(a, {}));
        Similarity motion;
        Eigen::VectorXf code = network->encode(a, &motion, {});
        const Eigen::VectorXf of_b = network->encode(b, nullptr, {});
        code.tail(code.size() - low) = of_b.tail(code.size() - low);
        EXPECT_LT(largest(network->mix(a, b, 0, 1, {}), network->decode(code, &motion, {})), 1e-3)
            << "exchange of the high bands";
        const Points half = network->mix(a, b, 0.5, 0.5, {});
        EXPECT_LT(largest(network->mix(b, a, 0.5, 0.5, {}), half), 60) << "another frame alone";
        EXPECT_EQ(band_status([&] { network->mix(a, b, std::nan(""), 0, {}); }),
                  Status::invalid_argument);
    }
}

TEST(BandNetwork, AnUnconditionedBandDoesNotSeeTheOther) {
    const TriMesh mesh = face_like(16);
    for (const double conditioning : {0.0, 0.4}) {
        const auto network = small_bands(mesh, NetworkOperator::mesh_autoencoder, conditioning);
        Eigen::VectorXf code = network->encode(bent(mesh.vertices, 1), nullptr, {});
        const auto high_of = [&] {
            return high_band(network->basis(), network->decode(code, nullptr, {}),
                             network->band_limit(), {});
        };
        const Points before = high_of();
        code.head(network->low_code_size()).array() += 0.7f;  // an edit of the low band
        const double change = largest(high_of(), before);
        if (conditioning == 0)
            EXPECT_LT(change, 1e-9);
        else
            EXPECT_GT(change, 1e-3);
    }
}

TEST(BandNetwork, DecodersTakeTheirOwnCodeFirstRowByRow) {
    Eigen::VectorXf own(4), other(2), expected(6);
    own << 1, 2, 3, 4;
    other << 5, 6;
    expected << 1, 2, 5, 3, 4, 6;
    EXPECT_EQ(joined_codes(own, other, 2), expected);
}

TEST(BandNetwork, SamplesFromTheTrainingCodes) {
    const TriMesh mesh = face_like(12);
    const auto plain = small_bands(mesh, NetworkOperator::spiralnet);
    EXPECT_EQ(band_status([&] { plain->sample(1, 0, 1); }), Status::unsupported_option);
    Matrix codes(plain->code_size(), 40);
    for (Index k = 0; k < codes.size(); ++k)
        codes.data()[k] = 3 + 0.5 * noise(static_cast<std::uint64_t>(k)) *
                                  static_cast<double>(1 + k % codes.rows());
    const auto network = small_bands(mesh, NetworkOperator::spiralnet, 1, code_distribution(codes));
    EXPECT_LT((network->sample(1, 0, 0).cast<double>() - codes.rowwise().mean()).norm(), 1e-5);
    EXPECT_EQ(network->sample(1, 3, 1), network->sample(1, 3, 1));
    EXPECT_NE(network->sample(1, 3, 1), network->sample(1, 4, 1));
    // Second moments come back, number by number.
    const Vector mean = codes.rowwise().mean();
    Vector truth = (codes.colwise() - mean).rowwise().squaredNorm() / 39, found = 0 * mean;
    for (std::uint64_t k = 0; k < 4000; ++k)
        found += (network->sample(2, k, 1).cast<double>() - mean).cwiseAbs2() / 4000;
    EXPECT_LT(((found - truth).array() / truth.array()).abs().maxCoeff(), 0.15);
    EXPECT_EQ(band_status([&] { network->sample(1, 0, -1); }), Status::invalid_argument);
}

TEST(BandNetwork, KeepsEveryNumberInItsFile) {
    const testing::ScratchFolder folder;
    const TriMesh mesh = face_like(14);
    const Points face = bent(mesh.vertices, 2);
    const std::string path = folder / "bands.safetensors";
    for (const NetworkOperator op : kAllOperators) {
        const auto network = small_bands(mesh, op, 0.4, code_distribution(Matrix::Random(48, 9)));
        network->save(path, {});
        const auto read = FaceNetwork::load(path, {}, {});
        EXPECT_EQ(read->encode(face, nullptr, {}), network->encode(face, nullptr, {}));
        EXPECT_EQ(read->apply(face, {}), network->apply(face, {}));
        EXPECT_EQ(read->json(), network->json());
        EXPECT_EQ(read->sample(4, 4, 1), network->sample(4, 4, 1));
        EXPECT_EQ(read->band_limit(), 12);
        EXPECT_EQ(band_status([&] { Network::load(path, {}, {}); }), Status::bad_format);
        if (op == NetworkOperator::spiralnet) break;  // the mesh autoencoder's code has other sizes
    }
}

TEST(BandNetwork, EveryTruncationIsATypedError) {
    const testing::ScratchFolder folder;
    const std::string path = folder / "bands.safetensors";
    small_bands(face_like(8), NetworkOperator::spiralnet)->save(path, {});
    const std::string bytes = testing::read_bytes(path);
    for (std::size_t k = 0; k < 40; ++k) {
        testing::write_bytes(path, bytes.substr(0, bytes.size() * k / 40));
        EXPECT_NE(band_status([&] { FaceNetwork::load(path, {}, {}); }), Status::ok) << k;
    }
}

TEST(BandNetwork, RefusesPartsThatDoNotBelongTogether) {
    const TriMesh mesh = face_like(12);
    const auto good = small_bands(mesh, NetworkOperator::spiralnet);
    const auto refused = [&](const std::function<void(BandNetwork::Parts&)>& change) {
        BandNetwork::Parts parts = good->parts();
        change(parts);
        return band_status([&] { BandNetwork::make(parts, {}); });
    };
    EXPECT_EQ(refused([](auto&) {}), Status::ok);
    EXPECT_EQ(refused([](auto& p) { std::swap(p.low, p.high); }), Status::bad_format);
    EXPECT_EQ(refused([](auto& p) { p.band_limit = 0; }), Status::bad_format);
    EXPECT_EQ(refused([](auto& p) { p.band_limit = 13; }), Status::bad_format);
    EXPECT_EQ(refused([](auto& p) { p.conditioning = 1.5; }), Status::bad_format);
    EXPECT_EQ(refused([](auto& p) { p.task = BandTask::expression; }), Status::bad_format);
    EXPECT_EQ(refused([&](auto& p) {
                  p.low = small_network(mesh, NetworkOperator::spiralnet, FeatureKind::euclidean);
              }),
              Status::bad_format);
    // A file with one half alone.
    const testing::ScratchFolder folder;
    EXPECT_EQ(band_status([&] { good->low().save(folder / "half.safetensors", {}); }),
              Status::invalid_argument);
}

TEST(ExpressionNetwork, AddsWhatItIsToldInTheFrameOfTheFace) {
    const TriMesh mesh = face_like(16);
    for (const FeatureKind kind :
         {FeatureKind::euclidean_standardised, FeatureKind::deformation_normalised}) {
        const auto input = FaceFeatures::train(mesh.triangles, face_source(mesh, 6), kind, {});
        const FacePairs pairs = face_pairs(mesh, 6);
        const auto output = train_displacements(*input, pairs, kind, FeatureSpread::per_vertex, {});
        Points neutral, expression;
        pairs.pair(2, neutral, expression);
        const Points moved = turned_away().apply(neutral);
        Similarity motion;
        const Points aligned = onto_mean_shape(moved, input->mean(), &motion);
        const Points truth = motion.apply(turned_away().apply(expression));
        const Features f = output->prepare(raw_displacement(*output, aligned, truth, {}));
        Points back = add_displacement(*output, aligned, f, {});
        // Deformations know no place.
        back.rowwise() += (truth.colwise().mean() - back.colwise().mean()).eval();
        EXPECT_LT(largest(back, truth), 1e-6);
        const auto network = small_displacement(mesh, kind);
        const Points here = network->apply(neutral, {}), there = network->apply(moved, {});
        EXPECT_LT(largest(turned_away().apply(here), there), 2e-3);
        EXPECT_FALSE(network->gives_faces_back());
        const Eigen::VectorXf code = network->encode(neutral, nullptr, {});
        EXPECT_EQ(band_status([&] { network->decode(code, nullptr, {}); }),
                  Status::unsupported_option);
    }
}

TEST(ExpressionNetwork, AssemblesTwoPredictionsAtAnyLimit) {
    const testing::ScratchFolder folder;
    const TriMesh mesh = face_like(16);
    const Points face = turned_away().apply(bent(mesh.vertices, 1));
    const auto network = small_expression(mesh, 9);
    const auto both = network->predict(face, {});
    EXPECT_EQ(network->apply(face, {}),
              assemble(network->basis(), both.spatial, both.differential, 9, {}));
    EXPECT_EQ(network->apply(face, 0, {}), both.differential);
    EXPECT_EQ(network->apply(face, kWholeBand, {}), both.spatial);
    const std::string path = folder / "expression.safetensors";
    network->save(path, {});
    const auto read = FaceNetwork::load(path, {}, {});
    EXPECT_EQ(read->apply(face, {}), network->apply(face, {}));
    EXPECT_EQ(read->json(), network->json());
    EXPECT_EQ(band_status([&] { read->mix(face, face, 0, 1, {}); }), Status::unsupported_option);
}

}  // namespace
}  // namespace mien
