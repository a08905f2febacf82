// A moving face: the core's Follower behind a handle.
#include "registration/follow.hpp"

#include <algorithm>
#include <utility>

#include "arrays.hpp"
#include "guard.hpp"
#include "model.hpp"
#include "options.hpp"
#include "registration.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

struct mien_follower : Object {
    static constexpr Tag kTag = Tag::follower;
    static constexpr const char* kName = "follower";
    mien_follower(std::shared_ptr<const DeformationModel> of, const PriorState& prior,
                  const Points& start, const FollowSettings& settings, const PinholeCamera& lens,
                  double to_mm, const Context& context)
        : Object(kTag),
          model(std::move(of)),
          camera(lens),
          unit_to_mm(to_mm),
          grid(settings.grid),
          follower(*model, prior, start, settings, context) {}
    const std::shared_ptr<const DeformationModel> model;
    const PinholeCamera camera;
    const double unit_to_mm;
    const DepthGridSettings grid;
    Follower follower;
};

namespace {

mien_follow_options default_follow_options() {
    const FollowSettings core;
    mien_follow_options options{};
    options.rounds = core.rounds;
    options.max_vertices = static_cast<std::int32_t>(core.vertices);
    options.max_scalar_modes = static_cast<std::int32_t>(core.kernel_modes);
    options.max_pca_modes = static_cast<std::int32_t>(core.pca_modes);
    options.temporal_mm = core.temporal_mm;
    options.sigma_start_mm = core.sigma_start_mm;
    options.sigma_end_mm = core.sigma_end_mm;
    options.lost_share = core.lost_share;
    options.unit_to_mm = 1;
    return options;
}

void check_range(const char* name, double value, double least, double most) {
    if (!(value >= least && value <= most))
        fail(Status::invalid_argument, "options.%s is %g, it must be %g to %g", name, value, least,
             most);
}

FollowSettings convert_follow(const mien_follow_options& given) {
    constexpr double kMost = 1e6;
    if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
    check_range("rounds", given.rounds, 1, 100);
    check_range("max_vertices", given.max_vertices, 100, kMost);
    check_range("max_scalar_modes", given.max_scalar_modes, 0, kMost);
    check_range("max_pca_modes", given.max_pca_modes, 0, kMost);
    check_range("temporal_mm", given.temporal_mm, 0, kMost);
    check_range("sigma_start_mm", given.sigma_start_mm, 1e-3, kMost);
    check_range("sigma_end_mm", given.sigma_end_mm, 1e-3, kMost);
    check_range("lost_share", given.lost_share, 0, 1);
    check_range("unit_to_mm", given.unit_to_mm, 1e-6, kMost);
    for (const auto& [name, value] :
         {std::pair{"focal_x", given.focal_x}, std::pair{"focal_y", given.focal_y},
          std::pair{"centre_x", given.centre_x}, std::pair{"centre_y", given.centre_y}})
        check_range(name, value, -kMost, kMost);
    if ((given.focal_x == 0) != (given.focal_y == 0))
        fail(Status::invalid_argument,
             "options.focal_x is %g and options.focal_y is %g: give both, or 0 for both",
             given.focal_x, given.focal_y);
    FollowSettings settings;
    settings.rounds = given.rounds;
    settings.vertices = given.max_vertices;
    settings.kernel_modes = given.max_scalar_modes;
    settings.pca_modes = given.max_pca_modes;
    settings.temporal_mm = given.temporal_mm;
    settings.sigma_start_mm = given.sigma_start_mm;
    settings.sigma_end_mm = given.sigma_end_mm;
    settings.lost_share = given.lost_share;
    settings.doubtful_share = std::max(settings.doubtful_share, given.lost_share);
    return settings;
}

}  // namespace

extern "C" {

void MIEN_CALL mien_follow_options_init(mien_follow_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_follow_options());
}

mien_status MIEN_CALL mien_follower_create(mien_session* session, const mien_model* model,
                                           const mien_registration* start,
                                           const mien_follow_options* options, mien_follower** out,
                                           mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_follow_options given =
            read_options(options, default_follow_options(),
                         MIEN_FIRST_SIZE(mien_follow_options, centre_y), "options");
        const std::shared_ptr<const DeformationModel> face = checked(model, "model").model;
        const Points places = checked(start, "start").mesh->mesh->vertices;
        const FollowSettings settings = convert_follow(given);
        const Call call(session);
        const RegistrationSettings core;
        ColorFeatureSettings no_colors;
        no_colors.enabled = false;
        const PriorState prior =
            choose_prior(*face, core.prior, core.inner, no_colors, call.context());
        return new mien_follower(face, prior, places, settings,
                                 {given.focal_x, given.focal_y, given.centre_x, given.centre_y},
                                 given.unit_to_mm, call.context());
    });
}

mien_status MIEN_CALL mien_follower_fit(mien_session* session, mien_follower* follower,
                                        const mien_array_view* points, int32_t width,
                                        int32_t height, mien_follow_state* out, mien_error* error) {
    return guarded(error, [&] {
        mien_follower& face = checked(follower, "follower");
        const mien_array_view& view = checked_view(points, "points");
        if (out == nullptr) fail(Status::invalid_argument, "out is null");
        if (width < 3 || height < 3)
            fail(Status::invalid_argument, "a frame of %d x %d pixels; it must have 3 a side",
                 width, height);
        const Call call(session);
        Points places = read_points(view, "points");
        places *= face.unit_to_mm;
        const DepthGrid grid(places, width, height, face.camera, face.grid);
        const FollowedFrame frame = face.follower.follow(grid, call.context());
        mien_follow_state state{};
        state.state = static_cast<std::int32_t>(frame.state);
        state.share = frame.share;
        state.residual_mm = frame.residual_mm;
        state.slide_mm = frame.slide_mm;
        write_struct(out, state, MIEN_FIRST_SIZE(mien_follow_state, slide_mm));
    });
}

mien_status MIEN_CALL mien_follower_get_mesh(const mien_follower* follower, mien_mesh** out,
                                             mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_follower& face = checked(follower, "follower");
        auto mesh = std::make_shared<TriMesh>();
        mesh->vertices = face.follower.places().cast<float>().cast<double>();
        mesh->triangles = face.follower.triangles();
        mesh->texture = face.model->template_mesh.texture;
        mesh->texture_triangles = face.model->template_mesh.texture_triangles;
        return new mien_mesh(std::move(mesh));
    });
}

mien_status MIEN_CALL mien_follower_get_motion(const mien_follower* follower, double* matrix,
                                               mien_error* error) {
    return guarded(error, [&] {
        const Similarity& motion = checked(follower, "follower").follower.motion();
        if (matrix == nullptr) fail(Status::invalid_argument, "matrix is null");
        check_output(matrix, "matrix");
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) matrix[4 * i + j] = motion.scale * motion.rotation(i, j);
            matrix[4 * i + 3] = motion.translation[i];
        }
        for (int j = 0; j < 4; ++j) matrix[12 + j] = j == 3 ? 1 : 0;
    });
}

void MIEN_CALL mien_follower_retain(mien_follower* follower) {
    retain(follower);
}

void MIEN_CALL mien_follower_release(mien_follower* follower) {
    release(follower);
}

}  // extern "C"
