// Does it matter how a scan lies in space? Each scan is registered without landmarks as it is,
// under the 24 turns of the cube and under random turns, and each fit is compared with the upright
// one.
//
//   pose_turns MODEL.safetensors [--random NUMBER] [--seed NUMBER] SCAN_FOLDER ...
//
// Prints for each scan the upright fit's error against the truth, by how much turned fits err more,
// how far their vertices lie from the upright fit's (turned back), how many were judged failed,
// what search scores they had, and their processor time over the upright fit's.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <Eigen/Geometry>
#include <random>

#include "registration_case.hpp"

using namespace mien;

namespace {

std::vector<Matrix3> cube_turns() {
    std::vector<Matrix3> turns;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
            for (int signs = 0; signs < 4 && x != y; ++signs) {
                Matrix3 turn = Matrix3::Zero();
                turn(x, 0) = signs % 2 == 0 ? 1 : -1;
                turn(y, 1) = signs / 2 == 0 ? 1 : -1;
                turn.col(2) = Vector3(turn.col(0)).cross(Vector3(turn.col(1)));
                turns.push_back(turn);
            }
    return turns;
}

// Any rotation is as likely as any other: four normal numbers, as a quaternion.
std::vector<Matrix3> random_turns(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Matrix3> turns;
    for (int k = 0; k < count; ++k) {
        const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
        turns.push_back(Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix());
    }
    return turns;
}

// As a file holds it: single precision.
Points turned(const Points& points, const Matrix3& turn) {
    return (points * turn.transpose()).cast<float>().cast<double>();
}

struct TurnedFit {
    double face_mm = 0, apart_mm = 0, seconds = 0, score = 0;
    FitQuality quality = FitQuality::failed;
    Points places;  // turned back
};

TurnedFit fit_turned(const DeformationModel& model, const Case& one, const Matrix3& turn,
                     const Context& context) {
    Case moved = one;
    moved.scan.vertices = turned(one.scan.vertices, turn);
    moved.truth = one.truth * turn.transpose();
    const std::clock_t before = std::clock();
    const RegistrationResult fit = register_scan(model, moved.scan, {}, {}, context);
    TurnedFit result;
    result.seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    result.face_mm = errors_of(model, {}, moved, fit).face_mm;
    result.score = fit.verdict.search_score;
    result.quality = fit.verdict.quality;
    result.places = fit.fitted.vertices * turn;
    return result;
}

void run(const DeformationModel& model, const std::vector<std::string>& folders,
         const std::vector<Matrix3>& turns, const Context& context) {
    std::printf(
        "| scan | upright, mm | score | s | turned: largest difference of the error, mm | of a "
        "vertex, mm | failed | scores | time, mean | largest |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    for (const std::string& folder : folders) {
        const Case one = read_case(folder, context);
        const TurnedFit upright = fit_turned(model, one, Matrix3::Identity(), context);
        double worse = 0, apart = 0, low = 1, high = 0, mean = 0, longest = 0;
        int failed = 0;
        for (const Matrix3& turn : turns) {
            const TurnedFit fit = fit_turned(model, one, turn, context);
            const double time = fit.seconds / upright.seconds;
            mean += time / static_cast<double>(turns.size());
            longest = std::max(longest, time);
            low = std::min(low, fit.score);
            high = std::max(high, fit.score);
            if (fit.quality == FitQuality::failed) {
                ++failed;
                continue;
            }
            worse = std::max(worse, std::abs(fit.face_mm - upright.face_mm));
            apart = std::max(apart, (fit.places - upright.places).rowwise().norm().maxCoeff());
        }
        std::printf(
            "| %s | %.3f | %.3f | %.2f | %.4f | %.4f | %d of %zu | %.3f to %.3f | %.2f | %.2f |\n",
            one.name.c_str(), upright.face_mm, upright.score, upright.seconds, worse, apart, failed,
            turns.size(), low, high, mean, longest);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
    int count = 20;
    unsigned seed = 1;
    std::vector<std::string> folders;
    for (int k = 2; k < argc; ++k) {
        if (std::strcmp(argv[k], "--random") == 0 && k + 1 < argc)
            count = std::atoi(argv[++k]);
        else if (std::strcmp(argv[k], "--seed") == 0 && k + 1 < argc)
            seed = static_cast<unsigned>(std::atoi(argv[++k]));
        else
            folders.push_back(argv[k]);
    }
    if (folders.empty()) {
        std::fprintf(stderr,
                     "usage: pose_turns MODEL.safetensors [--random NUMBER] [--seed NUMBER] "
                     "SCAN_FOLDER ...\n");
        return 2;
    }
    try {
        const Context context;
        const auto model = load_deformation_model(argv[1], {}, context);
        std::vector<Matrix3> turns = cube_turns();
        for (const Matrix3& turn : random_turns(count, seed)) turns.push_back(turn);
        run(*model, folders, turns, context);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "pose_turns: %s\n", error.what());
        return 1;
    }
    return 0;
}
