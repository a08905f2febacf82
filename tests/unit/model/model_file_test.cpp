#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "model/model_builder.hpp"
#include "model/template_walls.hpp"
#include "model/tuning.hpp"
#include "unit/model/support.hpp"

namespace mien {
namespace {

using model_test::bumpy_sheet;
using model_test::write_faces;

std::string temporary(const std::string& name) {
    return testing::TempDir() + "mien_model_" + name;
}

std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

BuiltModel full_model() {
    TriMesh mesh = bumpy_sheet(10);
    mesh.colors = Colors::Constant(121, 3, 77);
    const FaceDataset faces =
        FaceDataset::open(write_faces(mesh, 121, 5, temporary("faces.safetensors")), {}, {});
    ModelOptions options;
    options.num_modes =
        63;  // an odd number of scalar modes and of vertices: nothing lines up by itself
    options.mirror_symmetric = true;
    options.mirror_correlation = 0.5;
    options.pca_faces = &faces;
    return build_deformation_model(mesh, {{"nose", 60}, {"chin", 3}},
                                   {{"brow", {1, 5, 9}}, {"empty", {}}}, options, {});
}

TEST(ModelFile, KeepsEveryBit) {
    const auto model = full_model().model;
    const std::string path = temporary("whole.safetensors");
    save_deformation_model(path, *model, {});
    const auto loaded = load_deformation_model(path, {}, {});
    EXPECT_EQ(loaded->template_mesh.vertices, model->template_mesh.vertices);
    EXPECT_EQ(loaded->template_mesh.triangles, model->template_mesh.triangles);
    EXPECT_EQ(loaded->template_mesh.colors, model->template_mesh.colors);
    EXPECT_EQ(loaded->basis.map(), model->basis.map());
    EXPECT_EQ(loaded->eigenvalues, model->eigenvalues);
    EXPECT_EQ(loaded->mean_displacement, model->mean_displacement);
    EXPECT_EQ(loaded->pca_modes.map(), model->pca_modes.map());
    EXPECT_EQ(loaded->prior_variance, model->prior_variance);
    EXPECT_EQ(loaded->info, model->info);
    EXPECT_GT(model->pca_left_out_mm, 0);
    EXPECT_EQ(loaded->pca_left_out_mm, model->pca_left_out_mm);
    ASSERT_EQ(loaded->landmarks.size(), 2u);
    EXPECT_EQ(loaded->landmarks[1].name, "chin");
    EXPECT_EQ(loaded->landmarks[1].vertex, 3u);
    ASSERT_EQ(loaded->zones.size(), 2u);
    EXPECT_EQ(loaded->zones[0].vertices, (std::vector<std::uint32_t>{1, 5, 9}));
    EXPECT_TRUE(loaded->zones[1].vertices.empty());
    EXPECT_EQ(loaded->walls.size(), 121u);
    EXPECT_EQ(loaded->walls, model->walls);
    EXPECT_EQ(loaded->walls_key, walls_key(loaded->template_mesh, WallSettings()));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(loaded->basis.data) % 64, 0u);
    const std::string again = temporary("again.safetensors");
    save_deformation_model(again, *loaded, {});
    EXPECT_EQ(bytes_of(path), bytes_of(again));
}

TEST(ModelFile, WallsOfAnotherTemplateHaveAnotherKey) {
    const auto model = full_model().model;
    TriMesh moved = model->template_mesh;
    moved.vertices(60, 2) += 1e-9;
    EXPECT_NE(walls_key(moved, WallSettings()), model->walls_key);
    TriMesh turned = model->template_mesh;
    std::swap(turned.triangles(7, 1), turned.triangles(7, 2));
    EXPECT_NE(walls_key(turned, WallSettings()), model->walls_key);
    WallSettings other;
    other.rays = 17;
    EXPECT_NE(walls_key(model->template_mesh, other), model->walls_key);
}

TEST(ModelFile, OutlivesTheFileObjectAndTheBuilder) {
    const std::string path = temporary("alive.safetensors");
    save_deformation_model(path, *full_model().model, {});
    std::shared_ptr<const DeformationModel> loaded = load_deformation_model(path, {}, {});
    std::remove(path.c_str());
    EXPECT_TRUE(loaded->basis.map().allFinite());
}

TEST(ModelFile, DamageIsATypedError) {
    const std::string path = temporary("damage.safetensors");
    save_deformation_model(path, *full_model().model, {});
    const std::string good = bytes_of(path);
    const auto status_of = [&](const std::string& bytes,
                               const SafetensorsReadOptions& options = {}) {
        std::ofstream(path, std::ios::binary | std::ios::trunc)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        try {
            load_deformation_model(path, options, {});
        } catch (const Error& error) {
            return error.status();
        }
        return Status::ok;
    };
    EXPECT_EQ(status_of(good), Status::ok);
    EXPECT_NE(status_of(good.substr(0, good.size() / 2)), Status::ok);
    std::string flipped = good;
    flipped[good.size() - 2000] = static_cast<char>(flipped[good.size() - 2000] ^ 0x40);
    EXPECT_EQ(status_of(flipped), Status::corrupt);
    // Names are covered by the digest; whoever trusts the values still gets the structure checked.
    SafetensorsReadOptions trusting;
    trusting.verify_hash = trusting.verify_finite = false;
    std::string renamed = good;
    renamed.replace(renamed.find("mien-deformation-model"), 4, "mean");
    EXPECT_EQ(status_of(renamed), Status::corrupt);
    EXPECT_EQ(status_of(renamed, trusting), Status::wrong_kind);
    std::string other = good;
    other.replace(other.find("\"basis\""), 7, "\"basiz\"");
    EXPECT_EQ(status_of(other), Status::corrupt);
    EXPECT_EQ(status_of(other, trusting), Status::bad_format);
    EXPECT_NE(status_of(good.substr(0, good.size() - 64), trusting), Status::ok);
}

TEST(ModelFile, AForgedLengthLeftOutIsRefused) {
    const BuiltModel built = full_model();
    const std::string path = temporary("left_out.safetensors");
    for (const char* forged : {"", "-1", "0", "nan", "inf", "1e9", "0.8 mm", "0x1"}) {
        DeformationModel model = *built.model;
        model.info[kLeftOutInfo] = forged;
        save_deformation_model(path, model, {});
        try {
            load_deformation_model(path, {}, {});
            ADD_FAILURE() << forged;
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::bad_format) << forged;
        }
    }
    DeformationModel older = *built.model;
    older.info.erase(kLeftOutInfo);
    save_deformation_model(path, older, {});
    EXPECT_EQ(load_deformation_model(path, {}, {})->pca_left_out_mm, 0);
}

TEST(Tuning, FindsTheSigmaThatMadeTheFaces) {
    const TriMesh mesh = bumpy_sheet(16);
    // Faces drawn from a kernel of 18 mm.
    ModelOptions made;
    made.kernels[0] = {KernelKind::euclidean_se, 18.0, 3.0, 2.0};
    made.num_modes = 600;
    const auto truth = build_deformation_model(mesh, {}, {}, made, {}).model;
    FaceDatasetWriter writer(mesh.triangles, mesh.vertices.rows(), {"neutral"});
    for (int k = 0; k < 6; ++k) {
        const Matrix a = Matrix::NullaryExpr(truth->basis.cols, 3, [&](Index i, Index j) {
            return std::sin(12.9898 * static_cast<double>(i * 3 + j + 1) * (k + 1)) * 1.4;
        });
        writer.add(mesh.vertices + truth->basis.map().cast<double>() * a, k, 0);
    }
    writer.save(temporary("tune.safetensors"), {});
    const FaceDataset faces = FaceDataset::open(temporary("tune.safetensors"), {}, {});
    TuneOptions options;
    options.kernel = {KernelKind::euclidean_se, 1.0, 3.0, 2.0};
    options.sigmas_mm = {5, 9, 18, 36, 72};
    options.num_modes = 120;
    options.rho = 0.05;
    const TuneReport report = tune_kernel(mesh, faces, options, {});
    ASSERT_EQ(report.points.size(), 5u);
    EXPECT_EQ(report.points[report.best].sigma_mm, 18);
    for (const TunePoint& point : report.points) {
        EXPECT_EQ(point.residuals.size(), 6u);
        EXPECT_GE(point.residual_mean, report.points[report.best].residual_mean);
    }
    const std::string json = tune_json(report);
    EXPECT_NE(json.find("\"best_sigma_mm\":18"), std::string::npos);
    // The same numbers stand in a grid over scales and levels, and the truth is found in it.
    TuneOptions grid = options;
    grid.sigmas_mm = {9, 18};
    grid.scales_mm = {0.5, 3.0};
    grid.level_counts = {1, 2};
    const TuneReport all = tune_kernel(mesh, faces, grid, {});
    ASSERT_EQ(all.points.size(), 8u);
    EXPECT_EQ(all.points[3].sigma_mm, 18);
    EXPECT_EQ(all.points[3].scale_mm, 3);
    EXPECT_EQ(all.points[3].levels, 1);
    EXPECT_EQ(all.points[3].residuals, report.points[2].residuals);
    EXPECT_EQ(all.points[4].levels, 2);
    EXPECT_EQ(all.points[all.best].scale_mm, 3);
    EXPECT_NE(tune_json(all).find("\"best_scale_mm\":3,\"best_levels\":"), std::string::npos);
    grid.level_counts = {0};
    EXPECT_THROW(tune_kernel(mesh, faces, grid, {}), Error);
    options.sigmas_mm.clear();
    EXPECT_THROW(tune_kernel(mesh, faces, options, {}), Error);
    options.sigmas_mm = {10};
    options.faces = {99};
    EXPECT_THROW(tune_kernel(mesh, faces, options, {}), Error);
}

TEST(Tuning, ResidualsFallWithRhoAndVanishInsideTheSpan) {
    const TriMesh mesh = bumpy_sheet(10);
    ModelOptions options;
    options.num_modes = 90;
    const auto model = build_deformation_model(mesh, {}, {}, options, {}).model;
    const Eigen::MatrixXf basis = model->basis.map();
    const Points inside = basis.cast<double>() * Matrix::Constant(basis.cols(), 3, 0.3);
    const double loose = fit_residuals(basis, {inside}, 0, {})[0];
    const double mid = fit_residuals(basis, {inside}, 1, {})[0];
    const double stiff = fit_residuals(basis, {inside}, 100, {})[0];
    EXPECT_LT(loose, 1e-5 * inside.norm());
    EXPECT_LT(mid, stiff);
    EXPECT_LT(loose, mid);
    EXPECT_LE(stiff, inside.norm());
}

}  // namespace
}  // namespace mien
