// Networks through the C++ face and the C functions beneath it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <mien/mien.hpp>

#include "handles.hpp"
#include "small_network.hpp"

namespace {

using namespace mien;

constexpr std::uint32_t kSide = 9;
constexpr std::uint64_t kCode = 6;

std::vector<Position> sheet(double height) {
    std::vector<Position> points;
    for (std::uint32_t y = 0; y < kSide; ++y)
        for (std::uint32_t x = 0; x < kSide; ++x)
            points.push_back({8.0 * x + std::sin(2.0 * y), 8.0 * y,
                              height * std::sin(0.5 * x) * std::cos(0.4 * y)});
    return points;
}
std::vector<Triangle> cells() {
    std::vector<Triangle> triangles;
    for (std::uint32_t y = 0; y + 1 < kSide; ++y)
        for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
            const std::uint32_t a = y * kSide + x, b = a + 1, c = a + kSide, d = c + 1;
            triangles.push_back({a, b, d});
            triangles.push_back({a, d, c});
        }
    return triangles;
}

template <typename Body>
mien_status status_of(Body&& body) {
    try {
        body();
    } catch (const Exception& e) {
        return e.status();
    }
    return MIEN_OK;
}

class NetworkAbi : public ::testing::Test {
  protected:
    NetworkAbi() {
        std::vector<double> positions;
        for (const Position& p : sheet(10)) positions.insert(positions.end(), p.begin(), p.end());
        std::vector<std::uint32_t> triangles;
        for (const Triangle& t : cells()) triangles.insert(triangles.end(), t.begin(), t.end());
        bytes_ = mien_test::SmallNetwork(positions, triangles, kCode).bytes();
        std::ofstream(path_, std::ios::binary) << bytes_;
    }
    ~NetworkAbi() override { std::remove(path_.c_str()); }
    Mesh face(double height) const { return Mesh(session_, sheet(height), cells()); }

    Session session_;
    std::string bytes_;
    const std::string path_ = mien_test::temporary_path("network.safetensors");
};

double largest_difference(const std::vector<Position>& x, const std::vector<Position>& y) {
    double worst = 0;
    for (std::size_t v = 0; v < x.size(); ++v)
        for (std::size_t d = 0; d < 3; ++d) worst = std::max(worst, std::abs(x[v][d] - y[v][d]));
    return worst;
}

TEST_F(NetworkAbi, CodesDecodeToWhatApplyGives) {
    const Network network = Network::load(session_, path_);
    EXPECT_EQ(network.vertex_count(), kSide * kSide);
    EXPECT_EQ(network.code_count(), kCode);
    const Mesh given = face(13);
    Network::Motion motion;
    const std::vector<double> code = network.encode(session_, given, &motion);
    ASSERT_EQ(code.size(), kCode);
    EXPECT_NE(code[0], 0);
    const auto there = network.decode(session_, code, &motion).positions();
    EXPECT_LT(largest_difference(there, network.apply(session_, given).positions()), 1e-9);
    // Without the motion the face stands where the mean stands.
    const auto here = network.decode(session_, std::vector<double>(kCode, 0)).positions();
    EXPECT_LT(largest_difference(here, network.mean().positions()), 1e-4);
}

TEST_F(NetworkAbi, MemoryAndFileAreTheSameNetwork) {
    const Network network = Network::load(session_, path_);
    std::string copy = bytes_;
    const Network held = Network::from_memory(session_, copy.data(), copy.size());
    std::fill(copy.begin(), copy.end(), '\0');  // the host's bytes are not read again
    EXPECT_EQ(held.encode(session_, face(4)), network.encode(session_, face(4)));
    EXPECT_EQ(held.json(), network.json());
    EXPECT_NE(held.json().find("\"name\":\"small\""), std::string::npos) << held.json();
}

TEST_F(NetworkAbi, AReferenceKeepsTheNetwork) {
    mien_network* network = nullptr;
    ASSERT_EQ(MIEN_OK, mien_network_load(session_.get(), path_.c_str(), &network, nullptr));
    mien_network_retain(network);
    mien_network_release(network);
    std::uint64_t size = 0;
    EXPECT_EQ(MIEN_OK, mien_network_get_json(network, nullptr, 0, &size, nullptr));
    EXPECT_GT(size, 1u);
    mien_network_release(network);
}

TEST_F(NetworkAbi, TheCountNeedsNoWorkAndShortRoomStaysUntouched) {
    const Network network = Network::load(session_, path_);
    const Mesh given = face(4);
    std::uint64_t count = 0;
    double room[2] = {7, 7};
    EXPECT_EQ(mien_network_encode(session_.get(), network.get(), given.get(), nullptr, nullptr,
                                  nullptr, 0, &count, nullptr),
              MIEN_OK);
    EXPECT_EQ(count, kCode);
    EXPECT_EQ(mien_network_encode(session_.get(), network.get(), given.get(), nullptr, nullptr,
                                  room, 2, &count, nullptr),
              MIEN_E_BUFFER_TOO_SMALL);
    EXPECT_EQ(room[0], 7);
}

TEST_F(NetworkAbi, WrongInputsAreTypedErrors) {
    const Network network = Network::load(session_, path_);
    const Mesh other(session_, std::vector<Position>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                     std::vector<Triangle>{{0, 1, 2}});
    EXPECT_EQ(status_of([&] { network.encode(session_, other); }), MIEN_E_MISMATCH);
    EXPECT_EQ(status_of([&] { network.apply(session_, other); }), MIEN_E_MISMATCH);
    EXPECT_EQ(status_of([&] { network.decode(session_, {1, 2}); }), MIEN_E_MISMATCH);
    EXPECT_EQ(
        status_of([&] { network.decode(session_, std::vector<double>(kCode, std::nan(""))); }),
        MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { network.decode(session_, std::vector<double>(kCode, 1e300)); }),
              MIEN_E_INVALID_ARGUMENT);
    Network::Motion scaled{2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0};
    EXPECT_EQ(status_of([&] { network.decode(session_, std::vector<double>(kCode, 0), &scaled); }),
              MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { Network::load(session_, path_ + ".none"); }), MIEN_E_IO);
    for (std::size_t size : {0, 7, 100, 2000}) {
        mien_network* out = nullptr;
        EXPECT_EQ(mien_network_load_memory(session_.get(), bytes_.data(), size, &out, nullptr),
                  MIEN_E_BAD_FORMAT)
            << size;
        EXPECT_EQ(out, nullptr);
    }
}

TEST_F(NetworkAbi, MixesAndSamplesCodes) {
    const Network network = Network::load(session_, path_);
    EXPECT_EQ(network.low_code_count(), kCode);
    EXPECT_EQ(network.band_limit(), -1);
    const Mesh a = face(13), b = face(6);
    Network::Motion motion;
    std::vector<double> code = network.encode(session_, a, &motion);
    const std::vector<double> of_b = network.encode(session_, b);
    for (std::size_t k = 0; k < kCode; ++k) code[k] += 0.25 * (of_b[k] - code[k]);
    EXPECT_LT(largest_difference(network.mix(session_, a, b, 0.25, 9).positions(),
                                 network.decode(session_, code, &motion).positions()),
              1e-4)
        << "a network without bands takes the first weight";
    EXPECT_EQ(network.sample(5, 1), network.sample(5, 1));
    EXPECT_NE(network.sample(5, 1), network.sample(5, 2));
    EXPECT_EQ(network.sample(5, 1, 0), std::vector<double>(kCode, 0.25));
    EXPECT_EQ(status_of([&] { network.sample(5, 1, -1); }), MIEN_E_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { network.mix(session_, a, b, std::nan(""), 0); }),
              MIEN_E_INVALID_ARGUMENT);
}

TEST_F(NetworkAbi, CancelEndsACall) {
    const Network network = Network::load(session_, path_);
    mien_cancel* cancel = nullptr;
    ASSERT_EQ(mien_cancel_create(&cancel, nullptr), MIEN_OK);
    mien_cancel_request(cancel);
    EXPECT_EQ(status_of([&] { network.apply(session_, face(3), cancel); }), MIEN_E_CANCELLED);
    mien_cancel_release(cancel);
}

TEST_F(NetworkAbi, EvaluatesTheFacesAskedFor) {
    const std::string data = mien_test::temporary_path("network_faces.safetensors");
    DatasetWriter writer(session_, face(10), {"neutral", "grin"});
    for (int k = 0; k < 4; ++k) writer.add(sheet(9.0 + k), k / 2, k % 2);
    writer.save(session_, data);
    const Network network = Network::load(session_, path_);
    Network::Evaluation settings;
    EXPECT_NE(network.evaluate(session_, data, settings).find("\"faces\":4"), std::string::npos);
    settings.neutral_only = true;
    settings.subjects = {1};
    settings.perceptual = false;
    const std::string one = network.evaluate(session_, data, settings);
    EXPECT_NE(one.find("\"faces\":1"), std::string::npos) << one;
    EXPECT_EQ(one.find("dame"), std::string::npos) << one;
    settings.subjects = {77};
    EXPECT_EQ(status_of([&] { network.evaluate(session_, data, settings); }), MIEN_E_NOT_FOUND);
    std::remove(data.c_str());
}

}  // namespace
