// A whole registration and its stages with the portable loops and with AVX2, in turns:
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

// Processor seconds between the calls of progress, by what the registration does there.
struct StageClock {
    static constexpr int kStages = 5;
    static constexpr const char* kNames[kStages] = {"scan: cleaning, tree, normals", "start", "fit",
                                                    "closing the gap",
                                                    "repair, confidence, verdict"};
    double seconds[kStages] = {}, last = cpu_seconds();
    int now = 0;

    void enter(int stage) {
        const double time = cpu_seconds();
        seconds[now] += time - last;
        last = time;
        now = stage;
    }
    static std::int32_t listen(void* clock, std::int32_t stage, double fraction) {
        const bool done = fraction >= 1;
        int now = 4;
        if (stage == static_cast<std::int32_t>(Stage::alignment))
            now = fraction < 0.1 ? 0 : done ? 2 : 1;
        if (stage == static_cast<std::int32_t>(Stage::fitting)) now = done ? 3 : 2;
        if (stage == static_cast<std::int32_t>(Stage::refining)) now = done ? 4 : 3;
        static_cast<StageClock*>(clock)->enter(now);
        return 0;
    }
};

}  // namespace

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
            context.progress_function = StageClock::listen;
            context.progress_user = &clock;
            const double start = cpu_seconds();
            places[portable] = register_scan(*model, scan, landmarks, {}, context).fitted.vertices;
            clock.enter(4);
            if (clock.last - start < least[portable])
                least[portable] = clock.last - start, best[portable] = clock;
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
