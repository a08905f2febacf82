// A later visit's fit slides along the skin onto the freckles of the earlier one, and never onto
// another person's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/error.hpp"
#include "base/random.hpp"
#include "registration/reference_visit.hpp"
#include "small_face.hpp"

namespace {

using namespace mien;
using namespace mien::test;

/// One freckle in most cells of 4 mm; brightness 0 to 1 of a person's skin at rest.
double skin_at(double x, double y, std::uint64_t person) {
    constexpr double kCell_mm = 4;
    const CounterRandom random(person, 7);
    double shade = 1;
    const int cx = static_cast<int>(std::floor(x / kCell_mm)),
              cy = static_cast<int>(std::floor(y / kCell_mm));
    for (int i = cx - 1; i <= cx + 1; ++i)
        for (int j = cy - 1; j <= cy + 1; ++j) {
            const std::uint64_t cell =
                4 * static_cast<std::uint64_t>((i + 1000) * 10000 + j + 1000);
            if (random.uniform(cell) > 0.7) continue;
            const double dx = x - kCell_mm * (i + random.uniform(cell + 1)),
                         dy = y - kCell_mm * (j + random.uniform(cell + 2));
            const double radius = 0.9 + 0.9 * random.uniform(cell + 3);
            shade -= 0.3 * std::exp(-(dx * dx + dy * dy) / (radius * radius));
        }
    return shade;
}

struct Picture {
    std::uint64_t person = 1;
    bool plain = false;
    double treated_mm = 0;  ///< about (35, -20): no freckle, and redder
    Vector3 gain = Vector3(0.8, 0.75, 0.7);
    double tilt = 0;  ///< of the light, per 70 mm
    std::uint64_t noise = 1;
};

/// A sheet of its own triangulation with colours at its vertices.
TriMesh photographed(Index cells, const Picture& picture) {
    TriMesh scan = face_sheet(cells);
    scan.colors.resize(scan.vertices.rows(), 3);
    const CounterRandom random(picture.noise, 3);
    for (Index v = 0; v < scan.vertices.rows(); ++v) {
        const double x = scan.vertices(v, 0), y = scan.vertices(v, 1);
        const bool treated = std::hypot(x - 35, y + 20) < picture.treated_mm;
        const double shade = picture.plain || treated ? 1 : skin_at(x, y, picture.person);
        for (int k = 0; k < 3; ++k) {
            const double light = picture.gain[k] * (1 + picture.tilt * x / 70) *
                                 (treated ? (k == 0 ? 1.05 : 0.85) : 1);
            const double value =
                230 * light * shade + 2 * random.normal(static_cast<std::uint64_t>(3 * v + k));
            scan.colors(v, k) = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
        }
    }
    return scan;
}

/// The sheet's place over (x, y).
class Sheet {
  public:
    Sheet() : mesh_(face_sheet(200)), tree_(mesh_.vertices, mesh_.triangles, Context()) {}
    Vector3 at(double x, double y) const {
        const RayHit hit =
            tree_.first_hit(Vector3(std::clamp(x, -69.0, 69.0), std::clamp(y, -89.0, 89.0), 500),
                            Vector3(0, 0, -1));
        return Vector3(std::clamp(x, -69.0, 69.0), std::clamp(y, -89.0, 89.0), 500 - hit.t);
    }

  private:
    TriMesh mesh_;
    TriangleTree tree_;
};

class TextureTieTest : public testing::Test {
  protected:
    TextureTieTest() {
        model_.template_mesh = face_sheet(44);
        const Index n = model_.num_vertices();
        model_.walls.assign(static_cast<std::size_t>(n), 0);
        first_ = model_.template_mesh;
        second_ = first_;
        const Sheet sheet;
        for (Index v = 0; v < n; ++v) {
            first_.vertices.row(v) = sheet.at(rest(v).x(), rest(v).y()).transpose();
            const double dx = 1.6 + 0.8 * std::sin(rest(v).y() / 30),
                         dy = 1.2 * std::cos(rest(v).x() / 35);
            second_.vertices.row(v) = sheet.at(rest(v).x() + dx, rest(v).y() + dy).transpose();
        }
        fit_.confidence_mm = Vector::Constant(n, 1.5);
        fit_.weight = Vector::Ones(n);
        photo_.tilt = 0.25;
        photo_.gain = Vector3(0.55, 0.6, 0.5);
        photo_.noise = 2;
    }

    Vector3 rest(Index v) const { return model_.template_mesh.vertices.row(v).transpose(); }

    TiedVisit tie(const TriMesh& before, const TriMesh& after, const Context& context = {}) const {
        return tie_to_reference(model_, {first_, fit_, before}, {second_, fit_, after}, {},
                                context);
    }

    /// Median distance of the places from those of the first visit, inside the sheet and within
    /// `radius_mm` of (x, y).
    double median_off(const Points& places, double x = 0, double y = 0,
                      double radius_mm = 60) const {
        std::vector<double> off;
        for (Index v = 0; v < places.rows(); ++v)
            if (std::abs(rest(v).x()) < 50 && std::abs(rest(v).y()) < 65 &&
                std::hypot(rest(v).x() - x, rest(v).y() - y) < radius_mm)
                off.push_back((places.row(v) - first_.vertices.row(v)).norm());
        std::sort(off.begin(), off.end());
        return off[off.size() / 2];
    }

    DeformationModel model_;
    TriMesh first_, second_;  // fits: the same surface, slid along it
    RegistrationResult fit_;
    Picture photo_;  // of the second visit: other light, other noise
};

TEST_F(TextureTieTest, PlacesSlideOntoTheSkinOfTheFirstVisitInOtherLight) {
    const TiedVisit tied = tie(photographed(150, {}), photographed(131, photo_));
    ASSERT_TRUE(tied.tie.tied) << tied.tie.why_not;
    EXPECT_GT(median_off(second_.vertices), 1.2);
    EXPECT_LT(median_off(tied.fit.fitted.vertices), 0.3);
    EXPECT_GT(tied.tie.agreeing, 0.6);
    EXPECT_NEAR(tied.tie.median_slide_mm, median_off(second_.vertices), 0.5);
    // Along the surface: it fits the scan as before.
    EXPECT_LT(tied.fit.residual_mm.cwiseAbs().mean(), 0.15);
    EXPECT_EQ(tied.fit.correspondence.size(), static_cast<std::size_t>(model_.num_vertices()));
    // What the texture holds is as sure as the reference, and the tie's own deviation is small.
    for (Index v = 0; v < model_.num_vertices(); ++v) {
        EXPECT_TRUE(tied.tie.share[v] >= 0 && tied.tie.share[v] <= 1);
        if (tied.tie.share[v] > 0.5) {
            EXPECT_LT(tied.tie.sd_mm[v], 0.6);
        }
    }
}

TEST_F(TextureTieTest, AnotherPersonsSkinMovesNothing) {
    Picture other = photo_;
    other.person = 2;
    const TiedVisit tied = tie(photographed(150, {}), photographed(131, other));
    EXPECT_FALSE(tied.tie.tied);
    EXPECT_FALSE(tied.tie.why_not.empty());
    EXPECT_EQ(tied.fit.fitted.vertices, second_.vertices);
    EXPECT_EQ(tied.tie.slide_mm.maxCoeff(), 0);
    EXPECT_EQ(tied.tie.share.maxCoeff(), 0);
    EXPECT_NE(tied.fit.verdict.notes.back().find("nothing moved"), std::string::npos);
}

TEST_F(TextureTieTest, SkinWithoutDetailIsLeftToForm) {
    Picture before, after = photo_;
    before.plain = after.plain = true;
    const TiedVisit tied = tie(photographed(150, before), photographed(131, after));
    EXPECT_FALSE(tied.tie.tied);
    EXPECT_EQ(tied.fit.fitted.vertices, second_.vertices);
}

TEST_F(TextureTieTest, ATreatedSpotIsNotHeldAndDragsNothing) {
    Picture after = photo_;
    after.treated_mm = 14;
    const TiedVisit tied = tie(photographed(150, {}), photographed(131, after));
    ASSERT_TRUE(tied.tie.tied) << tied.tie.why_not;
    EXPECT_LT(median_off(tied.fit.fitted.vertices), 0.3);
    EXPECT_LT(median_off(tied.fit.fitted.vertices, 35, -20, 12), 0.6);  // the field goes on
    double held = 0, count = 0;
    for (Index v = 0; v < model_.num_vertices(); ++v)
        if (std::hypot(rest(v).x() - 35, rest(v).y() + 20) < 8) {
            held += tied.tie.share[v];
            ++count;
        }
    EXPECT_LT(held, 0.2 * count);
}

TEST_F(TextureTieTest, ThreadsChangeNoBit) {
    const TriMesh before = photographed(90, {}), after = photographed(101, photo_);
    ThreadPool pool(3);
    Context threads;
    threads.pool = &pool;
    const TiedVisit alone = tie(before, after), many = tie(before, after, threads);
    EXPECT_EQ(alone.fit.fitted.vertices, many.fit.fitted.vertices);
    EXPECT_EQ(alone.tie.sd_mm, many.tie.sd_mm);
    EXPECT_EQ(alone.tie.agreement, many.tie.agreement);
}

Status status_of(const std::function<void()>& work, std::string& message) {
    try {
        work();
    } catch (const Error& error) {
        message = error.what();
        return error.status();
    }
    return Status::ok;
}

TEST_F(TextureTieTest, WhatCannotBeComparedIsRefusedByName) {
    const TriMesh colored = photographed(60, {});
    TriMesh grey = colored, elsewhere = colored;
    grey.colors.resize(0, 3);
    elsewhere.vertices.col(2).array() += 40;
    std::string message;
    EXPECT_EQ(status_of([&] { tie(grey, colored); }, message), Status::invalid_argument);
    EXPECT_NE(message.find("reference scan has no colours"), std::string::npos) << message;
    EXPECT_EQ(status_of([&] { tie(colored, elsewhere); }, message), Status::mismatch);
    EXPECT_NE(message.find("does not lie under its fit"), std::string::npos) << message;
    TriMesh fewer = second_;
    fewer.triangles.conservativeResize(fewer.triangles.rows() - 1, 3);
    EXPECT_EQ(status_of(
                  [&] {
                      tie_to_reference(model_, {first_, fit_, colored}, {fewer, fit_, colored}, {},
                                       Context());
                  },
                  message),
              Status::mismatch);
    ReferenceSettings wild;
    wild.tie.most_slide_mm = 0;
    EXPECT_EQ(status_of(
                  [&] {
                      tie_to_reference(model_, {first_, fit_, colored}, {second_, fit_, colored},
                                       wild, Context());
                  },
                  message),
              Status::invalid_argument);
    CancelToken token;
    token.request();
    Context cancelled;
    cancelled.cancel = &token;
    EXPECT_EQ(status_of([&] { tie(colored, colored, cancelled); }, message), Status::cancelled);
}

TEST_F(TextureTieTest, AFarScanIsTiedWhereItIs) {
    const Vector3 far(4e5, -2e5, 1e5);
    TriMesh before = photographed(110, {}), after = photographed(101, photo_);
    const TiedVisit near = tie(before, after);
    after.vertices.rowwise() += far.transpose();
    TriMesh moved = second_;
    moved.vertices.rowwise() += far.transpose();
    const TiedVisit tied =
        tie_to_reference(model_, {first_, fit_, before}, {moved, fit_, after}, {}, Context());
    ASSERT_TRUE(near.tie.tied && tied.tie.tied);
    const Points back = tied.fit.fitted.vertices.rowwise() - far.transpose();
    EXPECT_LT((back - near.fit.fitted.vertices).rowwise().norm().maxCoeff(), 0.05);
}

}  // namespace
