#include "registration/solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "geometry/normals.hpp"
#include "registration/folds.hpp"
#include "registration/gap.hpp"
#include "registration/skin.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

ScanSurfaceSettings smoothing(double mm) {
    ScanSurfaceSettings settings;
    settings.smoothing_mm = mm;
    return settings;
}

FoldSettings turn_limit(double rad) {
    FoldSettings settings;
    settings.max_turn_rad = rad;
    return settings;
}

// For sheets without noise.
GapSettings soft_gap() {
    GapSettings settings;
    settings.field.smoothness = 2;
    return settings;
}

// The stacked 3V x 3r system, formed plainly, as the judge.
TEST(FitSolver, AgreesWithTheStackedSystem) {
    const SmallFace face = small_face(14, 4);
    const Index n = face.model.num_vertices(), r = face.model.basis.cols;
    const Matrix phi = face.model.basis.map().cast<double>();
    FitTerms terms;
    terms.reset(n);
    Matrix stacked = Matrix::Zero(3 * n, 3 * r), precision = Matrix::Zero(3 * n, 3 * n);
    Vector target(3 * n);
    for (Index i = 0; i < n; ++i) {
        const Vector3 normal = Vector3(std::sin(0.1 * i), std::cos(0.2 * i), 1.5).normalized();
        const Vector3 goal(std::sin(0.05 * i), 2 * std::cos(0.03 * i), 3);
        const double weight = 0.2 + 0.1 * static_cast<double>(i % 5), tau = 0.05;
        terms.add_planar(i, weight, tau, normal, goal);
        if (i % 9 == 0) terms.add_isotropic(i, 2, goal);
        Matrix3 h = weight * ((1 - tau) * normal * normal.transpose() + tau * Matrix3::Identity());
        if (i % 9 == 0) h += 2 * Matrix3::Identity();
        precision.block<3, 3>(3 * i, 3 * i) = h;
        target.segment<3>(3 * i) = goal;
        for (int axis = 0; axis < 3; ++axis)
            stacked.row(3 * i + axis).segment(axis * r, r) = phi.row(i);
    }
    FitStepOptions options;
    options.scalar_modes = r;
    options.kernel_ridge = 0.7;
    options.move = false;
    options.tolerance = 1e-6;
    options.solver.most_iterations = 500;
    FitCoefficients found;
    found.kernel.setZero(r, 3);
    FitSolver solver(face.model);
    solver.step(terms, face.model.template_mesh.vertices, options, found, {});
    const Matrix normal_matrix =
        stacked.transpose() * precision * stacked + 0.7 * Matrix::Identity(3 * r, 3 * r);
    const Vector expected = normal_matrix.ldlt().solve(stacked.transpose() * precision * target);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_LT((phi * (found.kernel.col(axis).cast<double>() - expected.segment(axis * r, r)))
                      .cwiseAbs()
                      .maxCoeff(),
                  5e-3);
}

// Pulls towards a smooth goal at the vertices that the solver looks at.
FitTerms pulls_at(const FitSolver& solver) {
    FitTerms terms;
    terms.reset(solver.num_rows());
    for (Index row = 0; row < solver.num_rows(); ++row) {
        const double i = static_cast<double>(solver.vertex(row));
        terms.add_isotropic(row, 0.2 + 0.1 * std::fmod(i, 5),
                            Vector3(std::sin(0.05 * i), 2 * std::cos(0.03 * i), 3));
    }
    return terms;
}

TEST(FitSolver, SolvesTheSameWithAPreconditionerOfOtherRows) {
    const SmallFace face = small_face(14, 4);
    const Index n = face.model.num_vertices();
    FitStepOptions options;
    options.scalar_modes = face.model.basis.cols;
    options.move = false;
    options.tolerance = 1e-6;
    options.solver.most_iterations = 500;
    FitCoefficients kept, fresh;
    kept.kernel.setZero(options.scalar_modes, 3);
    fresh.kernel.setZero(options.scalar_modes, 3);
    FitSolver went_on(face.model), began(face.model);
    std::vector<Index> few;
    for (Index i = 0; i < n; i += 9) few.push_back(i);
    went_on.use_rows(few, options.scalar_modes, 0, {});
    Points at(static_cast<Index>(few.size()), 3);
    for (std::size_t k = 0; k < few.size(); ++k)
        at.row(static_cast<Index>(k)) = face.model.template_mesh.vertices.row(few[k]);
    went_on.step(pulls_at(went_on), at, options, kept, {});
    EXPECT_FALSE(kept.kernel.isZero());
    went_on.use_rows({}, options.scalar_modes, 0, {});
    went_on.step(pulls_at(went_on), face.model.template_mesh.vertices, options, kept, {});
    began.step(pulls_at(began), face.model.template_mesh.vertices, options, fresh, {});
    EXPECT_LT(
        (went_on.displacement(kept, {}) - began.displacement(fresh, {})).cwiseAbs().maxCoeff(),
        5e-3);
}

TEST(FitSolver, FindsASmallMotion) {
    const SmallFace face = small_face(20);
    const Points& rest = face.model.template_mesh.vertices;
    const Similarity truth = motion_of(3, Vector3(1, 1, 0), Vector3(2, -3, 1));
    FitTerms terms;
    terms.reset(rest.rows());
    for (Index i = 0; i < rest.rows(); ++i)
        terms.add_isotropic(i, 1, truth.apply(Vector3(rest.row(i))) - rest.row(i).transpose());
    FitStepOptions options;
    FitCoefficients none;
    none.kernel.resize(0, 3);
    FitSolver solver(face.model);
    const Similarity found = solver.step(terms, rest, options, none, {});
    EXPECT_LT((found.rotation - truth.rotation).norm(), 5e-3);
    EXPECT_NEAR(found.scale, 1, 5e-3);
}

// A motion and smooth modes that undo it, and landmarks that outweigh the surface: only the prior
// tells the first two apart, far more weakly than the data. Preconditioned one by one they made the
// iterations wander, and with them what rounding differs between a scan and the same scan turned.
TEST(FitSolver, DoesNotWanderBetweenAMotionAndTheModesThatUndoIt) {
    SmallFace face = small_face(80, 12);
    const Points& rest = face.model.template_mesh.vertices;
    const Index n = rest.rows(), bumps = face.model.basis.cols;
    auto basis = std::make_shared<Eigen::MatrixXf>(n, bumps + 4);
    basis->leftCols(bumps) = face.model.basis.map();
    basis->col(bumps).setConstant(5);
    basis->rightCols(3) = (rest / 20).cast<float>();
    face.model.basis = {basis->data(), n, basis->cols()};
    face.model.eigenvalues = Vector::Ones(basis->cols());
    face.model.storage = basis;
    const Points normals = vertex_normals(rest, face.model.template_mesh.triangles);
    const Points goal = face.truth.rowwise() + Eigen::RowVector3d(3, -2, 1);
    FitTerms terms;
    terms.reset(n);
    for (Index i = 0; i < n; ++i) {
        terms.add_planar(i, 1, 0.1, normals.row(i).transpose(),
                         (goal.row(i) - rest.row(i)).transpose());
        if (i % 97 == 1) terms.add_isotropic(i, 200, (goal.row(i) - rest.row(i)).transpose());
    }
    FitStepOptions options;
    options.scalar_modes = basis->cols();
    options.tolerance = 0.01;
    FitCoefficients found;
    found.kernel.setZero(basis->cols(), 3);
    FitSolver solver(face.model);
    solver.step(terms, rest, options, found, {});
    EXPECT_LE(solver.iterations(), 8);
}

TEST(FitSolver, PriorVarianceForbidsWhatItExcludes) {
    SmallFace face = small_face(14, 4);
    const Index r = face.model.basis.cols;
    face.model.prior_variance = Matrix::Ones(r, 3);
    face.model.prior_variance.col(0).setZero();  // nothing moves along x
    FitTerms terms;
    terms.reset(face.model.num_vertices());
    for (Index i = 0; i < face.model.num_vertices(); ++i)
        terms.add_isotropic(i, 1, Vector3(5, 5, 5));
    FitStepOptions options;
    options.scalar_modes = r;
    options.move = false;
    options.tolerance = 1e-5;
    FitCoefficients found;
    found.kernel.setZero(r, 3);
    FitSolver solver(face.model);
    solver.step(terms, face.model.template_mesh.vertices, options, found, {});
    EXPECT_LT(found.kernel.col(0).norm(), 0.3 * found.kernel.col(1).norm());
}

TEST(FitSolver, WhereNothingIsSeenThePriorsMeanStands) {
    const SmallFace face = small_face(14, 4);
    const Index r = face.model.basis.cols;
    const Eigen::MatrixXf mean = Eigen::MatrixXf::Random(r, 3);
    FitTerms terms;
    terms.reset(face.model.num_vertices());
    FitStepOptions options;
    options.scalar_modes = r;
    options.kernel_mean = &mean;
    options.move = false;
    options.tolerance = 1e-5;
    FitCoefficients found;
    found.kernel.setZero(r, 3);
    FitSolver(face.model).step(terms, face.model.template_mesh.vertices, options, found, {});
    EXPECT_LT((found.kernel - mean).norm(), 1e-3 * mean.norm());
}

TEST(Growth, RunsFromFewToAll) {
    for (const ModeGrowth growth :
         {ModeGrowth::linear, ModeGrowth::exponential, ModeGrowth::cubic}) {
        EXPECT_EQ(modes_at(growth, 0, 10, 333), 10);
        EXPECT_EQ(modes_at(growth, 1, 10, 333), 333);
        Index last = 0;
        for (double f = 0; f <= 1; f += 0.05) {
            EXPECT_GE(modes_at(growth, f, 10, 333), last);
            last = modes_at(growth, f, 10, 333);
        }
    }
    EXPECT_EQ(modes_at(ModeGrowth::constant, 0, 10, 333), 333);
}

TEST(Correspondence, FiltersSayNoAtBordersAndAgainstNormals) {
    const SmallFace face = small_face(20);
    const ScanSurface scan = build_scan_surface(face.model.template_mesh, {}, {});
    Points places(3, 3), normals(3, 3);
    places << 0, 0, 90, 100, 0, 40, 0, 30, 70;
    normals << 0, 0, 1, 0, 0, 1, 0, 0, -1;
    Correspondences found;
    CorrespondenceSettings options;
    options.robust = RobustWeight::none;
    find_correspondences(scan, places, normals, options, found, {});
    EXPECT_GT(found.weight[0], 0);
    EXPECT_EQ(found.weight[1], 0);  // beyond the rim
    EXPECT_EQ(found.weight[2], 0);  // seen from behind
    options.reject_border = false;
    options.max_angle_deg = 180;
    find_correspondences(scan, places, normals, options, found, {});
    EXPECT_GT(found.weight[1], 0);
    EXPECT_GT(found.weight[2], 0);
}

// A filter that cuts takes a vertex on its verge in one frame and refuses it in another.
TEST(Correspondence, FiltersFadeInsteadOfCutting) {
    const TriMesh sheet = face_sheet(20);
    const ScanSurface scan = build_scan_surface(sheet, {}, {});
    CorrespondenceSettings options;
    options.robust = RobustWeight::none;
    // The weight beside the sheet's vertex `of` when one walks along `step`, or turns the normal by
    // an angle.
    const auto largest_jump = [&](Index of, const Vector3& step, double turn_rad) {
        constexpr int kSteps = 1000;
        Points places(kSteps, 3), normals(kSteps, 3);
        const Vector3 normal = scan.normals.row(of).transpose(), axis = normal.unitOrthogonal();
        for (int k = 0; k < kSteps; ++k) {
            const double f = k / (kSteps - 1.0);
            places.row(k) = scan.vertices.row(of) + f * step.transpose();
            normals.row(k) = (Eigen::AngleAxisd(f * turn_rad, axis) * normal).transpose();
        }
        Correspondences found;
        find_correspondences(scan, places, normals, options, found, {});
        EXPECT_GT(found.weight.maxCoeff(), 0.9);
        EXPECT_EQ(found.weight.minCoeff(), 0);
        return (found.weight.tail(kSteps - 1) - found.weight.head(kSteps - 1))
            .cwiseAbs()
            .maxCoeff();
    };
    EXPECT_LT(largest_jump(10 * 21 + 10, Vector3::Zero(), 1.5), 0.06) << "at the angle";
    EXPECT_LT(largest_jump(19 * 21 + 10, Vector3(20, 0, 0), 0), 0.06) << "at the border";
}

TEST(Correspondence, HitsBeyondTheLimitFadeOut) {
    const ScanSurface scan = build_scan_surface(face_sheet(20), {}, {});
    CorrespondenceSettings options;
    options.robust = RobustWeight::none;
    options.limit_mm = 5;
    Points places(4, 3), normals(4, 3);
    const Vector3 place = scan.vertices.row(10 * 21 + 6).transpose();
    const Vector3 normal = scan.normals.row(10 * 21 + 6).transpose();
    const double away_mm[4] = {1, 3.9, 4.5, 5.1};
    for (int k = 0; k < 4; ++k) {
        places.row(k) = (place + away_mm[k] * normal).transpose();
        normals.row(k) = normal.transpose();
    }
    Correspondences found;
    find_correspondences(scan, places, normals, options, found, {});
    EXPECT_EQ(found.weight[0], 1);
    EXPECT_NEAR(found.weight[1], 1, 0.05);
    EXPECT_GT(found.weight[2], 0.1);
    EXPECT_LT(found.weight[2], 0.9);
    EXPECT_EQ(found.weight[3], 0);
}

// Vertices past the end of a scan all ask for its rim, which belongs to one of them.
TEST(Correspondence, PlacesThatAnotherVertexIsNearestToAreNotMutual) {
    const ScanSurface scan = build_scan_surface(face_sheet(20), {}, {});
    CorrespondenceSettings options;
    options.robust = RobustWeight::none;
    options.reject_border = false;
    options.max_angle_deg = 180;
    Points places(5, 3), normals(5, 3);
    const Vector3 rim = scan.vertices.row(20 * 21 + 10).transpose();
    for (int k = 0; k < 5; ++k) {
        places.row(k) = (rim + 4.0 * k * Vector3::UnitX()).transpose();
        normals.row(k) << 0, 0, 1;
    }
    Correspondences found;
    find_correspondences(scan, places, normals, options, found, {});
    EXPECT_EQ(found.weight.minCoeff(), 1);
    options.mutual_mm = 10;
    find_correspondences(scan, places, normals, options, found, {});
    EXPECT_EQ(found.weight[0], 1);
    EXPECT_EQ(found.weight[1], 1);  // 4 of 10 mm away
    EXPECT_GT(found.weight[2], 0);  // 8
    EXPECT_LT(found.weight[2], 0.9);
    EXPECT_EQ(found.weight[3], 0);  // 12
}

TEST(Correspondence, SoftAssignmentAveragesTheScannersNoise) {
    TriMesh sheet = face_sheet(140);
    const Points clean = sheet.vertices;
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 0.3);
    for (Index i = 0; i < clean.rows(); ++i) sheet.vertices(i, 2) += noise(random);
    const ScanSurface truth = build_scan_surface(face_sheet(140), {}, {}),
                      scan = build_scan_surface(sheet, {}, {});
    std::vector<Index> of;  // places above the cheeks
    for (Index i = 0; i < clean.rows(); i += 7)
        if (std::abs(clean(i, 0)) < 50 && std::abs(clean(i, 0)) > 25 && std::abs(clean(i, 1)) < 55)
            of.push_back(i);
    const Index n = static_cast<Index>(of.size());
    Points places(n, 3), normals(n, 3);
    for (Index k = 0; k < n; ++k) {
        normals.row(k) = truth.normals.row(of[static_cast<std::size_t>(k)]);
        places.row(k) = clean.row(of[static_cast<std::size_t>(k)]) + 2 * normals.row(k);
    }
    const auto spread_mm = [&](double soft_mm) {
        CorrespondenceSettings options;
        options.robust = RobustWeight::none;
        options.soft_mm = soft_mm;
        Correspondences found;
        find_correspondences(scan, places, normals, options, found, {});
        EXPECT_EQ(found.weight.minCoeff(), 1);
        Vector off(n);
        for (Index k = 0; k < n; ++k)
            off[k] = normals.row(k).dot(found.hits[static_cast<std::size_t>(k)].point.transpose() -
                                        places.row(k));
        // Nearest places lie on the noise's peaks, softly or not: by how much they differ counts.
        EXPECT_NEAR(off.mean(), -1.75, 0.1);
        return std::sqrt((off.array() - off.mean()).square().mean());
    };
    EXPECT_LT(spread_mm(1), 0.8 * spread_mm(0));
}

TEST(Folds, AreFoundAndStraightened) {
    const TriMesh sheet = face_sheet(30);
    const VertexRings rings = build_rings(sheet.vertices.rows(), sheet.triangles);
    Points folded = sheet.vertices;
    EXPECT_TRUE(
        find_turned(sheet.vertices, sheet.triangles, rings, folded, turn_limit(1.0)).empty());
    folded.row(15 * 31 + 15) += Eigen::RowVector3d(9, 0, 0);  // over its neighbours
    EXPECT_FALSE(
        find_turned(sheet.vertices, sheet.triangles, rings, folded, turn_limit(1.0)).empty());
    const Points before = folded;
    const FoldCounts counts =
        straighten_turned(sheet.vertices, sheet.triangles, rings, turn_limit(1.0), folded);
    EXPECT_EQ(counts.after, 0);
    EXPECT_GT(counts.before, 0);
    EXPECT_LT((folded - sheet.vertices).rowwise().norm().maxCoeff(), 1);
    EXPECT_LT(((folded - before).rowwise().norm().array() > 0).count(), 60)
        << "only the fold's surroundings move";
}

TEST(Folds, NeedlesOfTheTemplateAreNone) {
    TriMesh sheet = face_sheet(10);
    sheet.vertices.row(30) = sheet.vertices.row(31);
    const VertexRings rings = build_rings(sheet.vertices.rows(), sheet.triangles);
    EXPECT_TRUE(find_turned(sheet.vertices, sheet.triangles, rings, sheet.vertices, turn_limit(1.0))
                    .empty());
}

// A part that turns as a whole, as a lid does that closes, is no fold.
TEST(Folds, TurnWithTheirNeighbourhoodAreNone) {
    const TriMesh sheet = face_sheet(30);
    const VertexRings rings = build_rings(sheet.vertices.rows(), sheet.triangles);
    const Matrix3 turn = Eigen::AngleAxisd(2.2, Vector3(1, 0.3, 0).normalized()).toRotationMatrix();
    const Points turned = sheet.vertices * turn.transpose();
    EXPECT_TRUE(
        find_turned(sheet.vertices, sheet.triangles, rings, turned, turn_limit(0.5)).empty());
}

// A vertex is pushed up until its triangles turn by more than 60 degrees. Cut at the limit, it fell
// back at once.
TEST(Folds, TurnsAreUndoneByShares) {
    TriMesh sheet = face_sheet(12);
    sheet.vertices.col(2).setZero();
    const VertexRings rings = build_rings(sheet.vertices.rows(), sheet.triangles);
    const Index middle = 6 * 13 + 6;
    const auto left = [&](double height) {
        Points places = sheet.vertices;
        places(middle, 2) = height;
        undo_turns(sheet.vertices, sheet.triangles, rings, {}, places);
        return places(middle, 2);
    };
    EXPECT_EQ(left(5), 5);
    EXPECT_LT(left(200), 1);
    double before = left(5), jump = 0;
    for (double height = 5; height < 60; height += 0.01) {
        const double now = left(height);
        jump = std::max(jump, std::abs(now - before));
        before = now;
    }
    EXPECT_LT(jump, 0.5);
}

TEST(Gap, IsClosedSmoothly) {
    const TriMesh sheet = face_sheet(40);
    TriMesh target = sheet;
    for (Index i = 0; i < target.vertices.rows(); ++i)
        target.vertices(i, 2) +=
            0.8 * gauss(target.vertices(i, 0), 25) * gauss(target.vertices(i, 1), 25);
    const ScanSurface scan = build_scan_surface(target, smoothing(0), {});
    Points places = sheet.vertices;
    raise_field(scan, sheet.triangles, build_rings(places.rows(), sheet.triangles),
                Vector::Ones(places.rows()), {}, 1, soft_gap(), places, {});
    std::vector<SurfaceHit> before, after;
    scan.tree.closest(sheet.vertices, 10, before, {});
    scan.tree.closest(places, 10, after, {});
    double gap_before = 0, gap_after = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
        gap_before += before[i].distance(), gap_after += after[i].distance();
    EXPECT_LT(gap_after, 0.25 * gap_before);
}

// An injection that the modes do not know stands three robust scales above the fit: it was cut off
// by half.
TEST(Gap, OfAHillBeyondTheRobustScaleIsClosedFromItsFoot) {
    const TriMesh sheet = face_sheet(40);
    TriMesh target = sheet;
    const auto height = [&](Index i) {
        return 3 * gauss(sheet.vertices(i, 0), 25) * gauss(sheet.vertices(i, 1), 25);
    };
    for (Index i = 0; i < target.vertices.rows(); ++i) target.vertices(i, 2) += height(i);
    ScanSurface scan = build_scan_surface(target, smoothing(0), {});
    const auto fitted = [&](const Vector& scan_weight, Points& places) {
        scan.weight = scan_weight;
        places = sheet.vertices;
        return raise_field(scan, sheet.triangles, build_rings(places.rows(), sheet.triangles),
                           Vector::Ones(places.rows()), {}, 1, soft_gap(), places, {});
    };
    Points places;
    const Vector weight = fitted(Vector(), places);
    std::vector<SurfaceHit> hits;
    scan.tree.closest(places, 10, hits, {});
    for (Index i = 0; i < places.rows(); ++i) {
        if (height(i) < 1.5) continue;
        EXPECT_LT(hits[static_cast<std::size_t>(i)].distance(), 0.2 * height(i));
        EXPECT_GT(weight[i], 0.8) << "what was reached was seen";
    }
    // A host that gives the hill no weight does not want it followed.
    Vector without_hill = Vector::Ones(target.vertices.rows());
    for (Index i = 0; i < without_hill.size(); ++i)
        if (height(i) > 0.1) without_hill[i] = 0;
    const Vector none = fitted(without_hill, places);
    for (Index i = 0; i < places.rows(); ++i)
        if (height(i) > 1.5) {
            EXPECT_LT(places(i, 2) - sheet.vertices(i, 2), 0.5 * height(i));
            EXPECT_EQ(none[i], 0);
        }
}

// It was once measured on the first edge of each triangle alone, and with it the reach of the
// smoothing.
TEST(ScanSurface, ItsResolutionDoesNotDependOnATrianglesFirstCorner) {
    TriMesh mesh = face_sheet(80);
    const ScanSurface scan = build_scan_surface(mesh, smoothing(4), {});
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        const std::uint32_t first = mesh.triangles(t, 0);
        mesh.triangles(t, 0) = mesh.triangles(t, 1);
        mesh.triangles(t, 1) = mesh.triangles(t, 2);
        mesh.triangles(t, 2) = first;
    }
    const ScanSurface turned = build_scan_surface(mesh, smoothing(4), {});
    EXPECT_NEAR(turned.spacing_mm, scan.spacing_mm, 1e-9);
    EXPECT_LT((turned.normals - scan.normals).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Skin, TonesOfSkinOutweighHairAndCloth) {
    Colors colors(7, 3);
    colors << 226, 184, 160, 205, 158, 130, 168, 118, 90, 120, 80, 60, 52, 36, 26, 58, 84, 150, 60,
        160, 60;
    const Vector weights = skin_weights(colors, {});
    for (int skin = 0; skin < 4; ++skin)
        for (int other = 4; other < 7; ++other)
            EXPECT_GT(weights[skin], 2 * weights[other]) << skin << " " << other;
    EXPECT_GE(weights.minCoeff(), 0.05);
    EXPECT_LE(weights.maxCoeff(), 1);
}

}  // namespace
}  // namespace mien
