// The thesis' size: a generated data set of 13,000 faces of 26,317 vertices (4 GB), trained from
// the file.
//
//   expression_size FOLDER [FACES VERTICES [qojpca]]
//
// Writes FOLDER/size.safetensors block by block, trains 50 + 50 modes from it, neutralizes one face
// many times and deletes the file. Prints times, and the peak of the resident memory of each step
// as the kernel counts it, mapped pages of the file included. Linux only: it reads and resets
// /proc/self.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <Eigen/Geometry>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "expression/neutralize.hpp"
#include "expression/training.hpp"

using namespace mien;

namespace {

constexpr Index kExpressions = 20;
constexpr Index kIdentityDirections = 40, kExpressionDirections = 24;

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

double status_mb(const char* field) {
    std::ifstream in("/proc/self/status");
    std::string word;
    for (double value; in >> word;)
        if (word == field && in >> value) return value / 1024.0;
    return std::nan("");
}

void forget_peak() {
    std::ofstream("/proc/self/clear_refs") << 5;
}

/// Smooth columns over a strip of vertices: sums of waves with falling amplitude.
Eigen::MatrixXf smooth_directions(Index vertices, Index count, double size_mm, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.0, 6.28);
    Eigen::MatrixXf columns(3 * vertices, count);
    for (Index k = 0; k < count; ++k) {
        const double phases[3] = {uniform(random), uniform(random), uniform(random)};
        for (Index i = 0; i < vertices; ++i)
            for (int axis = 0; axis < 3; ++axis)
                columns(3 * i + axis, k) = static_cast<float>(
                    size_mm / (1.0 + 0.3 * static_cast<double>(k)) *
                    std::sin(phases[axis] + 6.28 * (1.0 + static_cast<double>(k)) *
                                                static_cast<double>(i) /
                                                static_cast<double>(vertices)));
    }
    return columns;
}

/// Subjects with every expression, smooth identities and expressions, and 0.05 mm of noise per
/// coordinate.
void write_dataset(const std::string& path, Index faces, Index vertices) {
    const Index triangles = vertices - 2;
    const std::uint64_t sizes[] = {
        static_cast<std::uint64_t>(12 * faces * vertices), static_cast<std::uint64_t>(4 * faces),
        static_cast<std::uint64_t>(4 * faces), static_cast<std::uint64_t>(12 * triangles)};
    const std::string shapes[] = {
        "\"vertices\":{\"dtype\":\"F32\",\"shape\":[" + std::to_string(faces) + "," +
            std::to_string(vertices) + ",3]",
        "\"subject\":{\"dtype\":\"I32\",\"shape\":[" + std::to_string(faces) + "]",
        "\"expression\":{\"dtype\":\"I32\",\"shape\":[" + std::to_string(faces) + "]",
        "\"triangles\":{\"dtype\":\"U32\",\"shape\":[" + std::to_string(triangles) + ",3]"};
    std::string header =
        "{\"__metadata__\":{\"units\":\"millimetres\",\"expression_names\":\"[\\\"neutral\\\"";
    for (Index e = 1; e < kExpressions; ++e) header += ",\\\"e" + std::to_string(e) + "\\\"";
    header += "]\"}";
    std::uint64_t offset = 0;
    for (int k = 0; k < 4; ++k) {
        header += "," + shapes[k] + ",\"data_offsets\":[" + std::to_string(offset) + "," +
                  std::to_string(offset + sizes[k]) + "]}";
        offset += sizes[k];
    }
    header += "}";
    header.append((64 - (8 + header.size()) % 64) % 64, ' ');

    std::ofstream out(path, std::ios::binary);
    const std::uint64_t length = header.size();
    out.write(reinterpret_cast<const char*>(&length), 8);
    out.write(header.data(), static_cast<std::streamsize>(header.size()));
    const Eigen::MatrixXf identities = smooth_directions(vertices, kIdentityDirections, 4.0, 1);
    const Eigen::MatrixXf expressions = smooth_directions(vertices, kExpressionDirections, 2.0, 2);
    const Eigen::MatrixXf rest = 20.0f * smooth_directions(vertices, 1, 4.0, 3);
    std::mt19937 random(4);
    std::normal_distribution<float> normal;
    Eigen::MatrixXf poses(kExpressionDirections, kExpressions);
    for (Index k = 0; k < poses.size(); ++k) poses.data()[k] = normal(random);
    poses.col(0).setZero();
    std::vector<float> noise(65536);
    for (float& value : noise) value = 0.05f * normal(random);
    Eigen::VectorXf identity;
    for (Index face = 0; face < faces; ++face) {
        const Index expression = face % kExpressions;
        if (expression == 0) {
            Eigen::VectorXf own(kIdentityDirections);
            for (float& value : own) value = normal(random);
            identity = rest + identities * own;
        }
        Eigen::VectorXf strength = poses.col(expression);
        for (float& value : strength) value *= 1.0f + 0.2f * normal(random);
        Eigen::VectorXf points = identity + expressions * strength;
        const std::size_t shift = random() % noise.size();
        for (Index k = 0; k < points.size(); ++k)
            points[k] += noise[(shift + static_cast<std::size_t>(k) * 40503u) % noise.size()];
        out.write(reinterpret_cast<const char*>(points.data()),
                  static_cast<std::streamsize>(4 * points.size()));
    }
    auto numbers = [&](Index count, auto&& value) {
        for (Index k = 0; k < count; ++k) {
            const auto number = static_cast<std::int32_t>(value(k));
            out.write(reinterpret_cast<const char*>(&number), 4);
        }
    };
    numbers(faces, [](Index k) { return k / kExpressions; });
    numbers(faces, [](Index k) { return k % kExpressions; });
    numbers(3 * triangles, [](Index k) { return k / 3 + k % 3; });
    if (!out.flush()) fail(Status::io, "'%s' could not be written", path.c_str());
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2) return std::puts("expression_size FOLDER [FACES VERTICES [qojpca]]"), 2;
    const std::string path = std::string(argv[1]) + "/size.safetensors";
    const Index faces = argc > 3 ? std::atoll(argv[2]) : 13000,
                vertices = argc > 3 ? std::atoll(argv[3]) : 26317;
    double begin = seconds();
    write_dataset(path, faces, vertices);
    std::printf("%lld faces of %lld vertices: %.2f GB written in %.0f s\n",
                static_cast<long long>(faces), static_cast<long long>(vertices),
                12e-9 * static_cast<double>(faces * vertices), seconds() - begin);

    ThreadPool pool(2);
    Context context;
    context.pool = &pool;
    TrainOptions options;
    if (argc > 4) options.subspaces.method = TrainMethod::quasi_orthogonal;
    forget_peak();
    begin = seconds();
    const std::clock_t cpu = std::clock();
    TrainReport report;
    auto dataset = std::make_shared<FaceDataset>(FaceDataset::open(path, {false, false}, context));
    const auto model = train_expression_model(dataset, options, context, &report);
    std::printf(
        "trained in %.1f s (%.1f s of processor), %d iterations: peak resident %.0f MB "
        "(at the end %.0f MB own, %.0f MB of the mapped file)\n",
        seconds() - begin, double(std::clock() - cpu) / CLOCKS_PER_SEC, report.iterations,
        status_mb("VmHWM:"), status_mb("RssAnon:"), status_mb("RssFile:"));
    std::printf("explained %.5f of identities, %.5f of expressions\n", report.identity_explained,
                report.expression_explained);

    Points face, neutral;
    dataset->face(3, face);
    dataset->face(0, neutral);
    NeutralizationResult result;
    for (int threads : {1, 2}) {
        ThreadPool some(threads);
        context.pool = &some;
        result = neutralize(context, *model, face, Vector(), {});
        begin = seconds();
        const std::clock_t before = std::clock();
        constexpr int kRounds = 200;
        for (int round = 0; round < kRounds; ++round)
            result = neutralize(context, *model, face, Vector(), {});
        std::printf("one neutralization, %d threads: %.2f ms (%.2f ms of processor)\n", threads,
                    1e3 * (seconds() - begin) / kRounds,
                    1e3 * double(std::clock() - before) / CLOCKS_PER_SEC / kRounds);
    }
    context.pool = &pool;
    auto report_error = [&](const char* name) {
        std::printf(
            "%s: %.3f mm from the neutral face, before %.3f mm; residual %.3f mm (expected at most "
            "%.3f), "
            "noise %.3g mm2, turned %.2f degrees, doubted share %.3f\n",
            name, (result.neutral_vertices - neutral).rowwise().norm().mean(),
            (face - neutral).rowwise().norm().mean(), result.residual_rms_mm,
            model->expected_residual_mm, result.noise_mm2,
            Eigen::AngleAxisd(result.pose.rotation).angle() * 57.29578, result.doubted_share);
        for (const std::string& warning : neutralization_warnings(*model, result))
            std::printf("  %s\n", warning.c_str());
    };
    report_error("automatic pose");
    NeutralizeOptions options_keep;
    options_keep.pose = Pose::keep;
    result = neutralize(context, *model, face, Vector(), options_keep);
    report_error("kept pose");
    options_keep.fit.noise_mm2 = model->mixture_noise_mm2;
    result = neutralize(context, *model, face, Vector(), options_keep);
    report_error("kept pose, given noise (no doubt)");
    std::remove(path.c_str());
    return 0;
} catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
