// A face that moves before a depth camera is followed, lost when it is gone, and found again.
#include "registration/follow.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/thread_pool.hpp"
#include "depth_camera.hpp"
#include "registration/settings.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

struct Filmed {
    SmallFace face = small_face();
    DepthCamera camera;

    PriorState prior() const {
        const RegistrationSettings settings;
        return choose_prior(face.model, settings.prior, settings.inner, settings.colors, {});
    }
    /// The truth turned about the vertical and moved, with `open` of an expression, camera frame.
    Points places(double turn_deg, const Vector3& shift, double open = 0) const {
        Points shape = face.truth;
        shape += open *
                 (1.2f * face.model.basis.map().col(11) - 0.8f * face.model.basis.map().col(8))
                     .cast<double>() *
                 Eigen::RowVector3d(0, -0.3, 1);
        const Points turned =
            motion_of(turn_deg, Vector3(0.2, 1, 0), shift).apply(PointsRef(shape));
        return camera.from_face().apply(PointsRef(turned));
    }
    DepthGrid grid(const Points& places, unsigned seed) const {
        return DepthGrid(depth_frame(camera, places, face.model.template_mesh.triangles, 0.3, seed),
                         camera.width, camera.height, {}, {});
    }
    DepthGrid empty() const {
        return DepthGrid(Points::Constant(camera.width * camera.height, 3,
                                          std::numeric_limits<double>::quiet_NaN()),
                         camera.width, camera.height, {}, {});
    }
};

double error_mm(const Follower& follower, const Points& truth) {
    return (follower.places() - truth).rowwise().norm().mean();
}

TEST(Follow, AHeadThatTurnsAndAFaceThatMoves) {
    const Filmed stage;
    Follower follower(stage.face.model, stage.prior(), stage.places(0, Vector3::Zero()), {}, {});
    for (int k = 1; k <= 12; ++k) {
        const Points truth = stage.places(1.7 * k, Vector3(k, -k, 2 * k), k / 12.0);
        const FollowedFrame frame = follower.follow(stage.grid(truth, 100 + k), {});
        EXPECT_EQ(frame.state, FollowState::followed) << k;
        EXPECT_LT(error_mm(follower, truth), 1) << k;
        EXPECT_GT(frame.share, 0.8) << k;
        EXPECT_LT(frame.residual_mm, 0.5) << k;
    }
}

TEST(Follow, AFaceThatIsGoneIsLostAndFoundWhereItComesBack) {
    const Filmed stage;
    Follower follower(stage.face.model, stage.prior(), stage.places(0, Vector3::Zero()), {}, {});
    const Points before = follower.places();
    EXPECT_EQ(follower.follow(stage.empty(), {}).state, FollowState::lost);
    EXPECT_EQ(follower.places(), before) << "nothing is known of where it went";
    EXPECT_EQ(follower.follow(stage.empty(), {}).state, FollowState::lost);
    const Points back = stage.places(-15, Vector3(25, 10, 60), 0.5);
    EXPECT_EQ(follower.follow(stage.grid(back, 1), {}).state, FollowState::found_again);
    EXPECT_EQ(follower.follow(stage.grid(back, 2), {}).state, FollowState::followed);
    EXPECT_LT(error_mm(follower, back), 1.5);
}

TEST(Follow, SomethingElseInItsPlaceIsNotTheFace) {
    const Filmed stage;
    Follower follower(stage.face.model, stage.prior(), stage.places(0, Vector3::Zero()), {}, {});
    Points wall = stage.places(0, Vector3::Zero());
    wall.col(2).setConstant(480);
    EXPECT_EQ(follower.follow(stage.grid(wall, 3), {}).state, FollowState::lost);
}

TEST(Follow, HasTheSameBitsForAnyNumberOfThreads) {
    const Filmed stage;
    const Points truth = stage.places(4, Vector3(2, 1, 0), 0.3);
    Points alone;
    for (const int threads : {1, 2, 3}) {
        ThreadPool pool(threads);
        Context context;
        context.pool = &pool;
        Follower follower(stage.face.model, stage.prior(), stage.places(0, Vector3::Zero()), {},
                          context);
        follower.follow(stage.grid(truth, 5), context);
        if (threads == 1) alone = follower.places();
        EXPECT_EQ(follower.places(), alone) << threads;
    }
}

TEST(Follow, RefusesAStartOfAnotherTemplate) {
    const Filmed stage;
    try {
        const Follower follower(stage.face.model, stage.prior(), Points::Zero(7, 3), {}, {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::mismatch);
    }
}

TEST(DepthGrid, FindsItsCameraAndTheFeetOfPerpendiculars) {
    const Filmed stage;
    const Points places = stage.places(0, Vector3::Zero());
    const Points frame =
        depth_frame(stage.camera, places, stage.face.model.template_mesh.triangles, 0, 1);
    for (const double mirrored : {1.0, -1.0}) {  // cameras whose y runs up and z towards them
        Points given = frame;
        given.col(1) *= mirrored;
        given.col(2) *= mirrored;
        const DepthGrid grid(given, stage.camera.width, stage.camera.height, {}, {});
        EXPECT_NEAR(std::abs(grid.camera().focal_x), stage.camera.focal, 1e-2);
        EXPECT_NEAR(grid.camera().centre_y, stage.camera.pinhole().centre_y, 1e-2);
        TriMesh mesh;
        grid.to_mesh(mesh.vertices, mesh.triangles);
        const TriangleTree tree(mesh.vertices, mesh.triangles, {});
        int counted = 0;
        for (Index i = 0; i < mesh.vertices.rows(); i += 211) {
            const Vector3 place = mesh.vertices.row(i).transpose() + Vector3(0.5, -0.7, 2);
            const GridHit hit = grid.look(place);
            if (!hit.valid || hit.whole < 1) continue;
            ++counted;
            EXPECT_NEAR((hit.point - place).norm(), tree.closest(place).distance(), 0.5) << i;
            EXPECT_LT(hit.normal.dot(hit.point), 0) << i;
        }
        EXPECT_GT(counted, 50);
        // Triangles look at the camera.
        for (Index t = 0; t < mesh.triangles.rows(); t += 97) {
            const Vector3 a = mesh.vertices.row(mesh.triangles(t, 0)).transpose(),
                          b = mesh.vertices.row(mesh.triangles(t, 1)).transpose(),
                          c = mesh.vertices.row(mesh.triangles(t, 2)).transpose();
            EXPECT_LT((b - a).cross(c - a).dot(a), 0) << t;
        }
    }
}

TEST(DepthGrid, RefusesWhatIsNoPinholeCamerasFrame) {
    const auto status_of = [](const Points& points, Index width, Index height) {
        try {
            const DepthGrid grid(points, width, height, {}, {});
        } catch (const Error& error) {
            return error.status();
        }
        return Status::ok;
    };
    Points shuffled(900, 3);
    std::mt19937 random(3);
    for (Index i = 0; i < shuffled.size(); ++i)
        shuffled.data()[i] = 100 + 100 * (random() / 4294967296.0);
    EXPECT_EQ(status_of(shuffled, 30, 30), Status::invalid_argument);
    EXPECT_EQ(status_of(shuffled, 31, 30), Status::mismatch);
    EXPECT_EQ(status_of(shuffled, 900, 1), Status::mismatch);
    EXPECT_EQ(status_of(Points::Zero(900, 3), 30, 30), Status::ok) << "nothing was seen";
}

}  // namespace
}  // namespace mien
