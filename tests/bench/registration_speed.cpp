// A whole registration with the portable loops and with AVX2, in turns:
// registration_speed MODEL.safetensors SCAN.ply LANDMARKS.json
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "mesh/mesh_file.hpp"
#include "model/deformation_model.hpp"
#include "registration/registration.hpp"

using namespace mien;

namespace {

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: registration_speed MODEL.safetensors SCAN.ply LANDMARKS.json\n");
        return 2;
    }
    try {
        const Context context;
        const auto model = load_deformation_model(argv[1], {}, context);
        const TriMesh scan = read_mesh_file(argv[2], context);
        std::vector<LandmarkPoint> landmarks;
        const auto json = nlohmann::json::parse(std::ifstream(argv[3]));
        for (const auto& [name, place] : json["points"].items())
            landmarks.push_back({name, Vector3(place[0], place[1], place[2])});
        double best[2] = {1e9, 1e9};
        Points places[2];
        for (int turn = 0; turn < 10; ++turn) {
            const int portable = turn % 2;
            dense::use_portable_loops(portable == 1);
            const double start = cpu_seconds();
            places[portable] = register_scan(*model, scan, landmarks, {}, context).fitted.vertices;
            best[portable] = std::min(best[portable], cpu_seconds() - start);
        }
        const Vector apart = (places[0] - places[1]).rowwise().norm();
        std::printf("one thread, best of five: portable %.3f s, AVX2 %.3f s, %.2f times; %.2g mm apart, at most %.2g\n",
                    best[1], best[0], best[1] / best[0], apart.mean(), apart.maxCoeff());
    } catch (const Error& error) {
        std::fprintf(stderr, "registration_speed: %s\n", error.what());
        return 1;
    }
    return 0;
}
