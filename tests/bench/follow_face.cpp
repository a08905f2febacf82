// A moving head before a depth camera, followed frame by frame and fitted frame by frame:
//
//   follow_face MODEL.safetensors FACES.safetensors [EXPRESSION] [SUBJECTS] [EVERY]
//
// FACES: heads of the model's template by subject and expression. Each head turns by 20 degrees to
// a side while its face goes from neutral to the expression (mouth_stretch), 60 frames of 2 s and
// 320 x 200 pixels with noise. The first frame is registered; the follower takes the rest, and each
// EVERY-th frame (12) is registered alone too. Then the head is gone for three frames and comes
// back elsewhere. Prints mean distances from the truth over the visible vertices of the zone
// "face", and processor time per frame on one thread.
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "base/error.hpp"
#include "base/scalar_math.hpp"
#include "mesh/dataset.hpp"
#include "model/landmarks.hpp"
#include "registration/follow.hpp"
#include "registration/registration.hpp"
#include "unit/registration/depth_camera.hpp"

using namespace mien;

namespace {

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

struct Sums {
    double followed_mm = 0, single_mm = 0, followed_worst_mm = 0;
    double follow_s = 0, single_s = 0, find_s = 0;
    int compared = 0, frames = 0, lost = 0, doubtful = 0, times_found = 0;
};

struct Head {
    Points neutral, moved;

    Points at(double t, double turn_deg, const Vector3& shift,
              const test::DepthCamera& camera) const {
        Similarity motion;
        motion.rotation =
            Eigen::AngleAxisd(turn_deg * kRadiansPerDegree, Vector3(0.15, 1, 0.1).normalized())
                .toRotationMatrix();
        motion.translation = shift;
        const Points shape = neutral + t * (moved - neutral);
        return camera.from_face().apply(motion.apply(PointsRef(shape)));
    }
};

// Mean over the zone's vertices that the camera sees.
double error_mm(const Zone& face, const DepthGrid& grid, const Points& truth,
                const Points& places) {
    double sum = 0, count = 0;
    for (const std::uint32_t v : face.vertices) {
        const GridHit hit = grid.look(truth.row(v).transpose());
        if (!hit.valid || (hit.point - truth.row(v).transpose()).norm() > 1.5) continue;
        sum += (places.row(v) - truth.row(v)).norm();
        ++count;
    }
    return count > 0 ? sum / count : 0;
}

class Run {
  public:
    Run(const DeformationModel& model, int every) : model_(model), every_(every) {
        prior_ = choose_prior(model, settings_.prior, settings_.inner, settings_.colors, context_);
        face_ = find_zone(model.zones, "face");
        if (face_ == nullptr) fail(Status::not_found, "the model has no zone 'face'");
    }

    void subject(const Head& head, unsigned seed, Sums& sums) {
        const auto grid_of = [&](const Points& truth, unsigned number) {
            const Points frame = test::depth_frame(camera_, truth, model_.template_mesh.triangles,
                                                   0.4, 1000 * seed + number);
            return DepthGrid(frame, camera_.width, camera_.height, {}, follow_.grid);
        };
        const Points first = head.at(0, 0, Vector3::Zero(), camera_);
        const RegistrationResult start = single(grid_of(first, 0));
        Follower follower(model_, prior_, start.fitted.vertices, follow_, context_);
        constexpr int kFrames = 60;
        for (int k = 1; k <= kFrames; ++k) {
            const double share = static_cast<double>(k) / kFrames;
            const Points truth =
                head.at(share, 20 * share, Vector3(6 * share, -4 * share, 10 * share), camera_);
            const Points points = test::depth_frame(camera_, truth, model_.template_mesh.triangles,
                                                    0.4, 1000 * seed + k);
            const double begin = cpu_seconds();
            const DepthGrid grid(points, camera_.width, camera_.height, {}, follow_.grid);
            const FollowedFrame frame = follower.follow(grid, context_);
            sums.follow_s += cpu_seconds() - begin;
            ++sums.frames;
            sums.lost += frame.state == FollowState::lost;
            sums.doubtful += frame.state == FollowState::doubtful;
            if (k % every_ != 0) continue;
            const double before = cpu_seconds();
            const RegistrationResult alone = single(grid);
            sums.single_s += cpu_seconds() - before;
            const double followed = error_mm(*face_, grid, truth, follower.places());
            const double fitted = error_mm(*face_, grid, truth, alone.fitted.vertices);
            sums.followed_mm += followed;
            sums.single_mm += fitted;
            sums.followed_worst_mm = std::max(sums.followed_worst_mm, followed);
            ++sums.compared;
            std::printf(
                "  frame %2d: followed %.3f mm, alone %.3f mm; share %.3f, residual %.3f, "
                "slide %.2f mm\n",
                k, followed, fitted, frame.share, frame.residual_mm, frame.slide_mm);
        }
        come_back(head, seed, follower, sums);
    }

  private:
    void come_back(const Head& head, unsigned seed, Follower& follower, Sums& sums) {
        const Points nothing = Points::Constant(camera_.width * camera_.height, 3,
                                                std::numeric_limits<double>::quiet_NaN());
        for (int k = 0; k < 3; ++k)
            follower.follow(DepthGrid(nothing, camera_.width, camera_.height, {}, follow_.grid),
                            context_);
        for (int k = 0; k < 3; ++k) {
            const Points truth = head.at(0.3, -18, Vector3(-30, 15, 40 + k), camera_);
            const DepthGrid grid(
                test::depth_frame(camera_, truth, model_.template_mesh.triangles, 0.4,
                                  1000 * seed + 100 + static_cast<unsigned>(k)),
                camera_.width, camera_.height, {}, follow_.grid);
            const double begin = cpu_seconds();
            const FollowedFrame frame = follower.follow(grid, context_);
            if (k == 0) sums.find_s += cpu_seconds() - begin;
            if (frame.state == FollowState::lost) continue;
            const double error = error_mm(*face_, grid, truth, follower.places());
            std::printf("  back: found in frame %d, %.3f mm\n", k + 1, error);
            if (error < 4) ++sums.times_found;
            return;
        }
        std::printf("  back: not found in three frames\n");
    }

    RegistrationResult single(const DepthGrid& grid) {
        TriMesh scan;
        grid.to_mesh(scan.vertices, scan.triangles);
        RegistrationSettings settings = settings_;
        settings.intake.unit_to_mm = 1;
        return register_scan(model_, scan, {}, settings, context_);
    }

    const DeformationModel& model_;
    const int every_;
    const Context context_;
    const RegistrationSettings settings_;
    const FollowSettings follow_;
    const test::DepthCamera camera_;
    PriorState prior_;
    const Zone* face_ = nullptr;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr,
                     "usage: follow_face MODEL.safetensors FACES.safetensors [EXPRESSION] "
                     "[SUBJECTS] [EVERY]\n");
        return 2;
    }
    try {
        const Context context;
        const auto model = load_deformation_model(argv[1], {}, context);
        const FaceDataset faces = FaceDataset::open(argv[2], {}, context);
        const std::string wanted = argc > 3 ? argv[3] : "mouth_stretch";
        const int subjects = argc > 4 ? std::atoi(argv[4]) : 4;
        if (faces.num_vertices() != model->num_vertices())
            fail(Status::mismatch, "the faces have another template");
        Run run(*model, argc > 5 ? std::max(1, std::atoi(argv[5])) : 12);
        Sums sums;
        int done = 0;
        for (Index a = 0; a < faces.num_faces() && done < subjects; ++a) {
            if (faces.expression(a) != faces.neutral_expression()) continue;
            for (Index b = 0; b < faces.num_faces(); ++b) {
                if (faces.subject(b) != faces.subject(a) ||
                    faces.expression_names()[static_cast<std::size_t>(faces.expression(b))] !=
                        wanted)
                    continue;
                Head head;
                faces.face(a, head.neutral);
                faces.face(b, head.moved);
                std::printf("subject %d\n", faces.subject(a));
                run.subject(head, static_cast<unsigned>(faces.subject(a)) + 1, sums);
                ++done;
                break;
            }
        }
        if (done == 0) fail(Status::not_found, "no subject has the expression %s", wanted.c_str());
        std::printf(
            "%d subjects, %d frames: followed %.3f mm (at most %.3f), alone %.3f mm, ratio "
            "%.3f\n",
            done, sums.frames, sums.followed_mm / sums.compared, sums.followed_worst_mm,
            sums.single_mm / sums.compared, sums.followed_mm / sums.single_mm);
        std::printf(
            "processor ms a frame: followed %.1f, alone %.0f, found again %.0f; lost %d, "
            "doubtful %d, found again %d of %d\n",
            1e3 * sums.follow_s / sums.frames, 1e3 * sums.single_s / sums.compared,
            1e3 * sums.find_s / done, sums.lost, sums.doubtful, sums.times_found, done);
    } catch (const Error& error) {
        std::fprintf(stderr, "follow_face: %s\n", error.what());
        return 1;
    }
    return 0;
}
