// Do wrong landmarks cost more than leaving them out?
//
//   wrong_landmarks MODEL.safetensors [--seed NUMBER] SCAN_FOLDER ...
//
// Of each scan's landmarks a tenth, a fifth and a third are made wrong in three ways: anywhere in
// the scan's box, all at one placeholder (the origin), or moved by 15 to 40 mm along with nothing
// else. Prints the error with them, the error when they are left out instead, the difference, and
// how many of the wrong ones were rejected, and of the right ones.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <set>

#include "registration_case.hpp"

using namespace mien;

namespace {

enum class Fault { anywhere, placeholder, moved };
const char* const kFaultNames[] = {"anywhere", "one placeholder", "moved 15 to 40 mm"};

Vector3 wrong_place(Fault fault, const Case& one, const Vector3& right, std::mt19937& random) {
    std::uniform_real_distribution<double> share(0, 1);
    std::normal_distribution<double> normal;
    switch (fault) {
        case Fault::anywhere: {
            const Vector3 low = one.scan.vertices.colwise().minCoeff().transpose(),
                          high = one.scan.vertices.colwise().maxCoeff().transpose();
            const Vector3 at(share(random), share(random), share(random));
            return low + at.cwiseProduct(high - low);
        }
        case Fault::placeholder:
            return Vector3::Zero();
        case Fault::moved: {
            const Vector3 way(normal(random), normal(random), normal(random));
            return right + (15 + 25 * share(random)) * way.normalized();
        }
    }
    return right;
}

struct Row {
    double with_mm, without_mm;
    std::size_t rejected, wrongly;
};

Row try_fault(const DeformationModel& model, const Case& one, Fault fault, std::size_t count,
              std::mt19937& random, const Context& context) {
    std::vector<std::size_t> order(one.landmarks.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::shuffle(order.begin(), order.end(), random);
    const std::set<std::size_t> wrong(order.begin(),
                                      order.begin() + static_cast<std::ptrdiff_t>(count));
    std::vector<LandmarkPoint> given, left;
    std::set<std::string> names;
    for (std::size_t k = 0; k < one.landmarks.size(); ++k) {
        given.push_back(one.landmarks[k]);
        if (wrong.count(k) == 0) {
            left.push_back(one.landmarks[k]);
            continue;
        }
        given.back().point = wrong_place(fault, one, given.back().point, random);
        names.insert(given.back().name);
    }
    const RegistrationResult with = register_scan(model, one.scan, given, {}, context);
    const RegistrationResult without = register_scan(model, one.scan, left, {}, context);
    Row row{errors_of(model, {}, one, with).face_mm, errors_of(model, {}, one, without).face_mm, 0,
            0};
    for (const std::string& name : with.verdict.landmarks_rejected)
        ++(names.count(name) > 0 ? row.rejected : row.wrongly);
    return row;
}

void run(const DeformationModel& model, const std::vector<std::string>& folders, unsigned seed,
         const Context& context) {
    std::printf(
        "| scan | wrong | how | with, mm | left out, mm | difference | rejected | right ones "
        "rejected |\n|---|---:|---|---:|---:|---:|---:|---:|\n");
    double worst = -1e9, mean = 0;
    int count = 0;
    for (const std::string& folder : folders) {
        const Case one = read_case(folder, context);
        std::mt19937 random(seed);
        for (const Fault fault : {Fault::anywhere, Fault::placeholder, Fault::moved})
            for (const int part : {10, 5, 3}) {
                const std::size_t wrong = one.landmarks.size() / static_cast<std::size_t>(part);
                try {
                    const Row row = try_fault(model, one, fault, wrong, random, context);
                    const double difference = row.with_mm - row.without_mm;
                    worst = std::max(worst, difference);
                    mean += difference;
                    ++count;
                    std::printf("| %s | %zu | %s | %.3f | %.3f | %+.3f | %zu | %zu |\n",
                                one.name.c_str(), wrong, kFaultNames[static_cast<int>(fault)],
                                row.with_mm, row.without_mm, difference, row.rejected, row.wrongly);
                } catch (const Error& error) {
                    std::printf("| %s | %zu | %s | refused: %s |||||\n", one.name.c_str(), wrong,
                                kFaultNames[static_cast<int>(fault)], error.what());
                }
                std::fflush(stdout);
            }
    }
    std::printf("mean difference %+.3f mm, largest %+.3f mm\n", mean / std::max(1, count), worst);
}

}  // namespace

int main(int argc, char** argv) {
    unsigned seed = 1;
    std::vector<std::string> folders;
    for (int k = 2; k < argc; ++k) {
        if (std::strcmp(argv[k], "--seed") == 0 && k + 1 < argc)
            seed = static_cast<unsigned>(std::atoi(argv[++k]));
        else
            folders.push_back(argv[k]);
    }
    if (folders.empty()) {
        std::fprintf(stderr,
                     "usage: wrong_landmarks MODEL.safetensors [--seed NUMBER] SCAN_FOLDER ...\n");
        return 2;
    }
    try {
        const Context context;
        const auto model = load_deformation_model(argv[1], {}, context);
        run(*model, folders, seed, context);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "wrong_landmarks: %s\n", error.what());
        return 1;
    }
    return 0;
}
