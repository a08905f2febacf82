// A whole registration and its stages with the portable loops and with AVX2, in turns:
// registration_speed MODEL.safetensors SCAN.ply LANDMARKS.json
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
#include "registration_clock.hpp"

using namespace mien;

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr,
                     "usage: registration_speed MODEL.safetensors SCAN.ply LANDMARKS.json\n");
        return 2;
    }
    try {
        Context context;
        const auto model = load_deformation_model(argv[1], {}, context);
        const TriMesh scan = read_mesh_file(argv[2], context);
        std::vector<LandmarkPoint> landmarks;
        const auto json = nlohmann::json::parse(std::ifstream(argv[3]));
        for (const auto& [name, place] : json["points"].items())
            landmarks.push_back({name, Vector3(place[0], place[1], place[2])});
        StageClock best[2];
        double least[2] = {1e9, 1e9};
        Points places[2];
        for (int turn = 0; turn < 10; ++turn) {
            const int portable = turn % 2;
            dense::use_portable_loops(portable == 1);
            StageClock clock;
            clock.listen_to(context);
            places[portable] = register_scan(*model, scan, landmarks, {}, context).fitted.vertices;
            const double seconds = clock.finish();
            if (seconds < least[portable]) least[portable] = seconds, best[portable] = clock;
        }
        std::printf("%-30s %9s %9s\n", "one thread, best of five, s", "portable", "AVX2");
        const auto row = [](const char* name, double portable, double fast) {
            std::printf("%-30s %9.3f %9.3f  %.2f times\n", name, portable, fast, portable / fast);
        };
        for (int s = 0; s < StageClock::kStages; ++s)
            row(StageClock::kNames[s], best[1].seconds[s], best[0].seconds[s]);
        row("all", least[1], least[0]);
        const Vector apart = (places[0] - places[1]).rowwise().norm();
        std::printf("%.2g mm apart, at most %.2g\n", apart.mean(), apart.maxCoeff());
    } catch (const Error& error) {
        std::fprintf(stderr, "registration_speed: %s\n", error.what());
        return 1;
    }
    return 0;
}
