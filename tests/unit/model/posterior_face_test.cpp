// The posterior on faces: 68 landmarks of simulated people against their true surface.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/random.hpp"
#include "base/safetensors.hpp"
#include "base/thread_pool.hpp"
#include "geometry/alignment.hpp"
#include "mesh/mesh_file.hpp"
#include "model/model_builder.hpp"
#include "model/posterior.hpp"
#include "model/sampling.hpp"

namespace mien {
namespace {

constexpr Index kFaceVertices = 9409;

TEST(PosteriorOnFaces, LandmarksBringTheWholeFaceCloser) {
    const std::string folder = std::string(MIEN_SHARED_DATA) + "/ict/";
    if (!std::filesystem::exists(folder + "model.safetensors")) GTEST_SKIP() << "needs the shared data";
    ThreadPool pool(2);
    Context context;
    context.pool = &pool;
    const TriMesh mesh = read_mesh_file(folder + "template.ply", context);
    const SafetensorsFile file = SafetensorsFile::open(folder + "model.safetensors", {}, context);
    const Index n = mesh.vertices.rows();
    const auto* modes = static_cast<const float*>(file.tensor("identity_modes", DType::f32, {-1, n, 3}).data);
    const auto json = nlohmann::json::parse(std::ifstream(folder + "landmarks.json"));
    std::vector<std::uint32_t> landmarks;
    for (const auto& entry : json["vertices"]) landmarks.push_back(entry.get<std::uint32_t>());
    ASSERT_EQ(landmarks.size(), 68u);

    // People differ by several millimetres and smoothly: a wide kernel with their scale.
    ModelOptions options;
    options.kernels[0] = {KernelKind::geodesic_se, 60.0, 5.0, 2.0};
    const auto prior = build_deformation_model(mesh, {}, {}, options, context).model;

    const double noise = 0.5;
    for (std::uint64_t person = 0; person < 3; ++person) {
        const CounterRandom random(11, person);
        Points truth = mesh.vertices;
        for (Index k = 0; k < 100; ++k) {
            const double weight = random.normal(static_cast<std::uint64_t>(k));
            for (Index v = 0; v < n; ++v)
                for (int c = 0; c < 3; ++c) truth(v, c) += weight * static_cast<double>(modes[3 * (k * n + v) + c]);
        }
        Points at_template(68, 3), at_face(68, 3);
        for (Index i = 0; i < 68; ++i) {
            at_template.row(i) = mesh.vertices.row(landmarks[static_cast<std::size_t>(i)]);
            at_face.row(i) = truth.row(landmarks[static_cast<std::size_t>(i)]);
            for (int c = 0; c < 3; ++c)
                at_face(i, c) += noise * random.normal(static_cast<std::uint64_t>(1000 + 3 * i + c));
        }
        // The rigid start: what was seen, in the frame of the template.
        const Similarity motion = align_points(at_face, at_template, Vector(), false);
        at_face = motion.apply(at_face);
        truth = motion.apply(truth);
        std::vector<LandmarkObservation> seen;
        for (Index i = 0; i < 68; ++i)
            seen.push_back({landmarks[static_cast<std::size_t>(i)],
                            (at_face.row(i) - at_template.row(i)).transpose(), noise});
        const auto posterior = condition_model(*prior, seen, context);
        const Points mean = mesh.vertices + posterior->mean_displacement;

        const auto face_error = [&](const Points& guess) {
            return (guess - truth).topRows(kFaceVertices).rowwise().norm().mean();
        };
        double landmark_error = 0;
        const Points variance = pointwise_variance(*posterior, context);
        for (const std::uint32_t v : landmarks) {
            landmark_error += (mean.row(v) - truth.row(v)).squaredNorm() / (3 * 68);
            EXPECT_LE(std::sqrt(variance(v, 0)), noise);
        }
        landmark_error = std::sqrt(landmark_error);
        const double before = face_error(mesh.vertices), after = face_error(mean);
        std::printf("person %d: whole face %.2f -> %.2f mm, landmarks %.2f mm per axis for a noise of %.2f\n",
                    static_cast<int>(person), before, after, landmark_error, noise);
        EXPECT_LT(landmark_error, noise);
        EXPECT_LT(after, 0.6 * before);
    }
}

}  // namespace
}  // namespace mien
