// A moving face of the C++ face.
#ifndef MIEN_DETAIL_FOLLOW_HPP
#define MIEN_DETAIL_FOLLOW_HPP

#include "registration.hpp"

namespace mien {

/// mien_follow_options with its defaults.
struct FollowOptions : mien_follow_options {
    FollowOptions() { mien_follow_options_init(this, sizeof(mien_follow_options)); }
};

/// A face that is followed from frame to frame.
class Follower {
  public:
    Follower(const Session& session, const Model& model, const Registration& start,
             const FollowOptions& options = {}) {
        mien_follower* follower = nullptr;
        detail::call(mien_follower_create, session.get(), model.get(), start.get(), &options,
                     &follower);
        handle_.reset(follower);
    }
    /// One point a pixel, row by row, in the camera's frame; not finite or of depth 0: not seen.
    mien_follow_state fit(const Session& session, const std::vector<Position>& points,
                          std::int32_t width, std::int32_t height) {
        const mien_array_view view{points.data(), points.size(), sizeof(Position), MIEN_DTYPE_F64,
                                   0};
        return fit(session, view, width, height);
    }
    /// The same from the camera's own buffer.
    mien_follow_state fit(const Session& session, const mien_array_view& points, std::int32_t width,
                          std::int32_t height) {
        mien_follow_state state{};
        state.struct_size = sizeof state;
        detail::call(mien_follower_fit, session.get(), handle_.get(), &points, width, height,
                     &state);
        return state;
    }
    /// Of the last frame that was not lost, camera frame, mm.
    Mesh mesh() const {
        mien_mesh* mesh = nullptr;
        detail::call(mien_follower_get_mesh, handle_.get(), &mesh);
        return Mesh(mesh);
    }
    /// Row-major 4 x 4, template to camera.
    std::array<double, 16> motion() const {
        std::array<double, 16> matrix{};
        detail::call(mien_follower_get_motion, handle_.get(), matrix.data());
        return matrix;
    }
    const mien_follower* get() const noexcept { return handle_.get(); }

  private:
    detail::Handle<mien_follower, mien_follower_release> handle_;
};

}  // namespace mien

#endif
