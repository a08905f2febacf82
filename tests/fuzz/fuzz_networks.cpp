// Feeds damaged network files to the reader and runs what it accepts: fuzz_networks [iterations]
// [seed]. An Error, or faces and codes of finite numbers, are right; anything else is a fault.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "fuzz/mutate.hpp"
#include "unit/learning/network_support.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

struct Tally {
    long read = 0, run = 0;
};

/// Empty when all is right.
std::string feed(const char* data, std::size_t size, const Points& face, Tally& tally) {
    try {
        SafetensorsReadOptions trusting;
        trusting.verify_hash = false;
        Context context;
        context.max_bytes = std::size_t(1) << 28;
        const SafetensorsFile file = SafetensorsFile::from_memory(data, size, trusting, context);
        const auto network = FaceNetwork::read(file, context);
        ++tally.read;
        const Eigen::VectorXf code = network->encode(face, nullptr, context);
        const Points made = network->gives_faces_back() ? network->decode(code, nullptr, context)
                                                        : network->apply(face, context);
        network->json();
        if (network->codes() != nullptr && !network->sample(1, 1, 1).allFinite())
            return "a sample that is no number";
        ++tally.run;
        if (!code.allFinite() || !made.allFinite()) return "numbers that are none";
    } catch (const Error& error) {
        if (error.status() == Status::internal || error.what()[0] == '\0') return error.what();
    } catch (const std::exception& error) {
        return error.what();
    }
    return std::string();
}

}  // namespace

int main(int argc, char** argv) {
    const long iterations = argc > 1 ? std::atol(argv[1]) : 6000;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    const TriMesh mesh = test::face_like(5);
    const ScratchFolder folder;
    std::vector<std::string> seeds;
    for (const NetworkOperator op : test::kAllOperators) {
        const std::string path = folder / "network";
        test::small_network(mesh, op, FeatureKind::euclidean_standardised)->save(path, {});
        seeds.push_back(read_bytes(path));
    }
    const std::string path = folder / "bands";
    test::small_bands(mesh, NetworkOperator::spiralnet, 0.4,
                      code_distribution(Matrix::Random(48, 9)))
        ->save(path, {});
    seeds.push_back(read_bytes(path));
    test::small_expression(mesh, 9)->save(path, {});
    seeds.push_back(read_bytes(path));
    long faults = 0;
    Tally tally;
    double slowest = 0;
    for (long k = 0; k < iterations && faults < 10; ++k) {
        fuzz::Random random(seed * 0x100000001b3ULL + static_cast<std::uint64_t>(k));
        const std::string damaged = fuzz::mutate(seeds[random.below(seeds.size())],
                                                 seeds[random.below(seeds.size())], random);
        // Exactly so long, so that a sanitizer sees the first byte too far; aligned as a file is.
        const std::unique_ptr<double[]> exact(new double[damaged.size() / 8 + 1]);
        std::copy(damaged.begin(), damaged.end(), reinterpret_cast<char*>(exact.get()));
        const auto begin = std::chrono::steady_clock::now();
        const std::string fault =
            feed(reinterpret_cast<const char*>(exact.get()), damaged.size(), mesh.vertices, tally);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        slowest = std::max(slowest, taken.count());
        if (fault.empty()) continue;
        ++faults;
        const std::string name = "fault-" + std::to_string(k) + ".safetensors";
        write_bytes(name, damaged);
        std::printf("iteration %ld: %s; see %s\n", k, fault.c_str(), name.c_str());
    }
    std::printf("%ld damaged networks, %ld read, %ld run, %ld faults, slowest %.1f ms\n",
                iterations, tally.read, tally.run, faults, 1e3 * slowest);
    return faults == 0 ? 0 : 1;
}
