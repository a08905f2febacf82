// A fit that follows a moving face: frame after frame of a depth camera, each from the one before.
//
// What a first registration found, whatever found it, becomes the shape at rest: details that no
// mode spans go along. The template's modes then move about that shape, with the motion of the
// head, by rounds of projective point to plane (depth_grid.hpp). Nothing is cleaned, no tree is
// built, no verdict is given, but two things are told: whether the face is still there, and how far
// it has slid along its skin.
#pragma once

#include <memory>

#include "registration/correspondence.hpp"
#include "registration/depth_grid.hpp"
#include "registration/fit_state.hpp"
#include "registration/prior.hpp"
#include "registration/search.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct FollowSettings {
    int motion_rounds = 4;     ///< >= 0: per frame, of the head's motion alone [J]
    double still_mm = 0.02;    ///< mm, > 0: a head that moves less is where it belongs [J]
    int rounds = 3;            ///< >= 1: per frame [J]
    int rounds_found = 8;      ///< >= 1: of a frame in which a lost face was searched [J]
    Index vertices = 2500;     ///< >= 100, about: that pull in a round [J]
    Index kernel_modes = 250;  ///< >= 0: of the model's, the strongest [J]
    Index pca_modes = 60;      ///< >= 0: of the trained ones, the strongest [J]
    double sigma_start_mm = 1.5, sigma_end_mm = 0.7;  ///< mm, > 0: noise levels of a frame [J]
    double sigma_found_mm = 5;  ///< mm, > 0: first noise level after a search [J]
    double robust_factor = 2;   ///< > 0: robust scale in noise levels [J]
    double reach_mm = 15;       ///< mm, > 0: farther hits do not pull [J]
    double weight = 0.03;       ///< > 0: independent hits per vertex [J]
    double tangential = 0.02;   ///< 0 to 1: weight of sliding along the surface [J]
    /// mm, >= 0: deviation of a vertex from where it was on the head one frame before, as if each
    /// were seen there too; 0: frames know nothing of each other but where they begin. [J]
    double temporal_mm = 4;
    double max_angle_deg = 60, angle_ramp_deg = 5;  ///< between the normals of vertex and hit [J]
    // What is told
    double near_mm = 4;       ///< mm, > 0: a vertex so near to the surface lies on it [J]
    double lost_share = 0.5;  ///< 0 to 1: with a smaller share of them on it the face is lost [J]
    double doubtful_share = 0.7;   ///< 0 to 1 [J]
    double doubtful_slide_mm = 4;  ///< mm, > 0 [J]
    double found_score = 0.56;     ///< 0 to 1: of the pose search; as the verdict's limit [J]
    DepthGridSettings grid;
    SearchSettings search;
    SolverSettings solver;
};

/// The numbers are the C ABI's numbers.
enum class FollowState : std::int32_t { followed = 0, doubtful = 1, found_again = 2, lost = 3 };

struct FollowedFrame {
    FollowState state = FollowState::lost;
    double share = 0;        ///< 0 to 1: of the vertices that face the camera: on the surface
    double residual_mm = 0;  ///< of these, mean distance
    double slide_mm = 0;     ///< median way along the skin since the first frame
    Similarity motion;       ///< shape at rest (model frame) -> camera
};

/// One moving face. Not shared between threads.
class Follower {
  public:
    /// `start`: #V x 3, the template as it was fitted, in the camera's frame, mm. `prior`: of the
    /// same model, of which nothing is borrowed but what its `storage` keeps alive. Throws
    /// Status::mismatch for another number of vertices, invalid_argument for places that are not
    /// finite.
    Follower(const DeformationModel& model, const PriorState& prior, const PointsRef& start,
             const FollowSettings& settings, const Context& context);

    /// Fits one frame. A face that is lost is searched in each frame until it is found; places()
    /// then stay what they were. O(rounds #V modes); a search is as dear as a registration.
    FollowedFrame follow(const DepthGrid& grid, const Context& context);

    /// #V x 3, camera frame, of the last frame that was not lost.
    const Points& places() const { return state_.places; }
    /// Shape at rest (model frame) -> camera, of the same frame.
    const Similarity& motion() const { return state_.motion; }
    const Triangles& triangles() const { return shape_.template_mesh.triangles; }

  private:
    struct Sight {
        double share, residual_mm;
    };

    void choose_rows(Index wanted, const Context& context);
    void correspond(const DepthGrid& grid, const Points& normals, double sigma_mm,
                    const Context& context);
    void move_rigidly(const DepthGrid& grid, double sigma_mm, const Context& context);
    void run_rounds(const DepthGrid& grid, int rounds, double sigma_start_mm, bool remember,
                    const Context& context);
    Sight look(const DepthGrid& grid, const Context& context) const;
    bool search(const DepthGrid& grid, const Context& context);
    double slide_mm() const;

    const FollowSettings settings_;
    FitState state_, at_rest_;
    const DeformationModel shape_;  // the model, about the shape at rest
    const std::vector<std::uint8_t> inner_;
    FitFreedom freedom_;
    FitSolver solver_;
    std::vector<Index> row_vertices_;
    double stride_ = 1;
    std::vector<GridHit> hits_;
    Vector weights_;
    bool lost_ = false;
};

}  // namespace mien
