#include "spectral/spectral_basis.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"
#include "unit/scratch.hpp"

namespace mien {
namespace {

std::shared_ptr<const SpectralBasis> basis_of(const TriMesh& mesh, Index modes) {
    SpectralBasisOptions options;
    options.num_modes = modes;
    return build_spectral_basis(mesh, options, {});
}

class Bands : public ::testing::Test {
  protected:
    TriMesh mesh_ = test::face_like();
    std::shared_ptr<const SpectralBasis> basis_ = basis_of(mesh_, 80);
    Points face_ = test::noisy(test::bent(mesh_.vertices, 2), 0.3);
    Context context_;
};

TEST_F(Bands, AddUpToTheFace) {
    const auto bands = split_bands(*basis_, face_, {10, 40, 80}, context_);
    ASSERT_EQ(bands.size(), 4u);
    Points sum = mesh_.vertices;
    for (const Points& band : bands) sum += band;
    EXPECT_LT((sum - face_).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((merge_bands(*basis_, bands, {10, 40, 80}, context_) - face_).cwiseAbs().maxCoeff(),
              1e-9);
}

TEST_F(Bands, LowAndHighGiveTheFaceBack) {
    const Points low = low_band(*basis_, face_, 50, context_),
                 high = high_band(*basis_, face_, 50, context_);
    EXPECT_LT((low + high - mesh_.vertices - face_).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((assemble(*basis_, low, high, 50, context_) - face_).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(Bands, ProjectionIsIdempotentAndOrthonormal) {
    const Points low = low_band(*basis_, face_, 30, context_);
    EXPECT_LT((low_band(*basis_, low, 30, context_) - low).cwiseAbs().maxCoeff(), 1e-9);
    const Matrix coefficients = Matrix::Random(80, 3);
    const Matrix back =
        project(*basis_, synthesise(*basis_, coefficients, 0, context_), 80, context_);
    EXPECT_LT((back - coefficients).cwiseAbs().maxCoeff(), 1e-8);
}

TEST_F(Bands, MergingDropsWhatDoesNotBelongToABand) {
    auto bands = split_bands(*basis_, face_, {20}, context_);
    const Points before = merge_bands(*basis_, bands, {20}, context_);
    bands[0] += high_band(*basis_, face_, 60, context_) -
                mesh_.vertices;  // high frequencies put into the low band
    EXPECT_LT((merge_bands(*basis_, bands, {20}, context_) - before).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(Bands, GainsOfOneKeepAndOfZeroSmooth) {
    const Vector ones = Vector::Ones(2);
    EXPECT_LT((edit_bands(*basis_, face_, {40}, ones, context_) - face_).cwiseAbs().maxCoeff(),
              1e-10);
    Vector smooth(2);
    smooth << 1, 0;
    EXPECT_LT((edit_bands(*basis_, face_, {40}, smooth, context_) -
               low_band(*basis_, face_, 40, context_))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-9);
}

TEST_F(Bands, MixingExchangesDetail) {
    const Points other = test::noisy(mesh_.vertices, 0.5, 99);
    Vector weights(2);
    weights << 0, 1;
    const Points mixed = mix_bands(*basis_, face_, other, {40}, weights, context_);
    EXPECT_LT((mixed - assemble(*basis_, face_, other, 40, context_)).cwiseAbs().maxCoeff(), 1e-9);
    weights << 1, 1;
    EXPECT_LT(
        (mix_bands(*basis_, face_, other, {40}, weights, context_) - other).cwiseAbs().maxCoeff(),
        1e-9);
}

TEST_F(Bands, AssembleEndsAtTheWholeFaces) {
    const Points other = test::noisy(mesh_.vertices, 0.5, 99);
    EXPECT_TRUE(assemble(*basis_, face_, other, 0, context_) == other);
    EXPECT_TRUE(assemble(*basis_, face_, other, basis_->num_vertices(), context_) == face_);
}

TEST_F(Bands, SameBitsForOneAndThreeThreads) {
    ThreadPool pool(3);
    Context three;
    three.pool = &pool;
    EXPECT_TRUE(low_band(*basis_, face_, 70, context_) == low_band(*basis_, face_, 70, three));
}

TEST_F(Bands, FileGivesTheSameBasis) {
    const mien::testing::ScratchFolder scratch;
    const std::string path = scratch / "basis.safetensors";
    save_spectral_basis(path, *basis_, context_);
    const auto loaded = load_spectral_basis(path, {}, context_);
    EXPECT_TRUE(loaded->values == basis_->values);
    EXPECT_TRUE(low_band(*loaded, face_, 80, context_) == low_band(*basis_, face_, 80, context_));
    EXPECT_EQ(loaded->mass_kind, "mixed_voronoi");
}

TEST_F(Bands, RefuseWhatDoesNotFit) {
    const Points shorter = face_.topRows(10);
    EXPECT_EQ(test::status_of([&] { low_band(*basis_, shorter, 10, context_); }), Status::mismatch);
    EXPECT_EQ(test::status_of([&] { low_band(*basis_, face_, 81, context_); }),
              Status::invalid_argument);
    EXPECT_EQ(test::status_of([&] {
                  split_bands(*basis_, face_, {20, 20}, context_);
              }),
              Status::invalid_argument);
    EXPECT_EQ(test::status_of([&] { edit_bands(*basis_, face_, {20}, Vector::Ones(1), context_); }),
              Status::invalid_argument);
    Points broken = face_;
    broken(3, 1) = std::nan("");
    EXPECT_EQ(test::status_of([&] { high_band(*basis_, broken, 10, context_); }),
              Status::invalid_mesh);
}

TEST(SpectralBasis, WithoutMassIsOrthonormalAsItStands) {
    SpectralBasisOptions options;
    options.num_modes = 20;
    options.with_mass = false;
    const auto basis = build_spectral_basis(test::face_like(), options, {});
    EXPECT_EQ(basis->mass.minCoeff(), 1.0);
    EXPECT_EQ(basis->mass_kind, "none");
}

}  // namespace
}  // namespace mien
