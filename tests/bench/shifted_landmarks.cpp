// What do landmarks cost that all lie to one side of the face, as given and moved back?
//
//   shifted_landmarks MODEL.safetensors [--seed NUMBER] SCAN_FOLDER ...
//
// Each scan's landmarks are moved by 0, 3, 6 and 9 mm in a random direction. Prints the error of
// the fit that takes them as they are given, and of the fit that may move them back.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

#include "registration_case.hpp"

using namespace mien;

namespace {

constexpr double kShifts_mm[] = {0, 3, 6, 9};
const char* const kQualities[] = {"good", "doubtful", "failed"};

struct Fitted {
    double face_mm;
    const char* quality;
};

Fitted fit(const DeformationModel& model, const Case& one,
           const std::vector<LandmarkPoint>& landmarks, bool mend, const Context& context) {
    RegistrationSettings settings;
    settings.shifted.mend = mend;
    const RegistrationResult made = register_scan(model, one.scan, landmarks, settings, context);
    return {errors_of(model, {}, one, made).face_mm,
            kQualities[static_cast<int>(made.verdict.quality)]};
}

void run(const DeformationModel& model, const std::vector<std::string>& folders, unsigned seed,
         const Context& context) {
    std::printf(
        "| scan | shifted, mm | as given, mm | verdict | moved back, mm | verdict |\n"
        "|---|---:|---:|---|---:|---|\n");
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (const std::string& folder : folders) {
        const Case one = read_case(folder, context);
        const double x = normal(random), y = normal(random), z = normal(random);
        const Vector3 way = Vector3(x, y, z).normalized();
        for (const double shift_mm : kShifts_mm) {
            std::vector<LandmarkPoint> landmarks = one.landmarks;
            for (LandmarkPoint& landmark : landmarks) landmark.point += shift_mm * way;
            const Fitted given = fit(model, one, landmarks, false, context),
                         moved = fit(model, one, landmarks, true, context);
            std::printf("| %s | %g | %.3f | %s | %.3f | %s |\n", one.name.c_str(), shift_mm,
                        given.face_mm, given.quality, moved.face_mm, moved.quality);
            std::fflush(stdout);
        }
    }
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
        std::fprintf(
            stderr, "usage: shifted_landmarks MODEL.safetensors [--seed NUMBER] SCAN_FOLDER ...\n");
        return 2;
    }
    try {
        const Context context;
        const auto model = load_deformation_model(argv[1], {}, context);
        run(*model, folders, seed, context);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "shifted_landmarks: %s\n", error.what());
        return 1;
    }
    return 0;
}
