// A whole registration and its stages with the portable loops, with AVX2, and with AVX2 on two
// threads, in turns:
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
        ThreadPool two(2);
        enum { fast, portable, threaded, num_ways };
        StageClock best[num_ways];
        double least[num_ways];
        std::fill(least, least + num_ways, std::numeric_limits<double>::max());
        Points places[num_ways];
        for (int turn = 0; turn < 5 * num_ways; ++turn) {
            const int way = turn % num_ways;
            dense::use_portable_loops(way == portable);
            context.pool = way == threaded ? &two : nullptr;
            StageClock clock;
            clock.listen_to(context);
            places[way] = register_scan(*model, scan, landmarks, {}, context).fitted.vertices;
            const double seconds = clock.finish();
            if (seconds < least[way]) least[way] = seconds, best[way] = clock;
        }
        std::printf("%-30s %9s %9s %12s %11s %8s\n", "best of five, wall, s", "portable", "AVX2",
                    "two threads", "AVX2 gains", "threads");
        const auto row = [](const char* name, double slow, double one, double both) {
            std::printf("%-30s %9.3f %9.3f %12.3f %11.2f %8.2f\n", name, slow, one, both,
                        slow / one, one / both);
        };
        for (int s = 0; s < StageClock::kStages; ++s)
            row(StageClock::kNames[s], best[portable].seconds[s], best[fast].seconds[s],
                best[threaded].seconds[s]);
        row("all", least[portable], least[fast], least[threaded]);
        const Vector apart = (places[fast] - places[portable]).rowwise().norm();
        std::printf("AVX2 from portable %.2g mm, at most %.2g; two threads from one %.2g\n",
                    apart.mean(), apart.maxCoeff(),
                    (places[fast] - places[threaded]).cwiseAbs().maxCoeff());
    } catch (const Error& error) {
        std::fprintf(stderr, "registration_speed: %s\n", error.what());
        return 1;
    }
    return 0;
}
