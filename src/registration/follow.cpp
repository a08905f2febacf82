#include "registration/follow.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/scalar_math.hpp"
#include "geometry/alignment.hpp"
#include "geometry/normals.hpp"
#include "registration/fit_terms.hpp"
#include "registration/scan_surface.hpp"

namespace mien {
namespace {

constexpr std::size_t kChunk = 256;  // vertices at a time

// The model about `start` as its mean, size and all, and the motion to there.
DeformationModel shape_of(const DeformationModel& model, const PriorState& prior,
                          const PointsRef& start, Similarity& motion) {
    const Points& rest = model.template_mesh.vertices;
    if (start.rows() != rest.rows())
        fail(Status::mismatch, "following a face: %lld places for a template of %lld vertices",
             static_cast<long long>(start.rows()), static_cast<long long>(rest.rows()));
    if (!start.allFinite())
        fail(Status::invalid_argument, "following a face: the first places are not all finite");
    Vector open(rest.rows());
    for (Index i = 0; i < open.size(); ++i)
        open[i] = prior.inner[static_cast<std::size_t>(i)] ? 0 : 1;
    motion = align_points(rest, start, open, false);
    DeformationModel shape = model;
    shape.mean_displacement = motion.inverse().apply(start) - rest;
    return shape;
}

}  // namespace

Follower::Follower(const DeformationModel& model, const PriorState& prior, const PointsRef& start,
                   const FollowSettings& settings, const Context& context)
    : settings_(settings),
      shape_(shape_of(model, prior, start, state_.motion)),
      inner_(prior.inner),
      freedom_(prior.freedom),
      solver_(shape_) {
    state_.kernel_amplitude = prior.kernel_amplitude;
    state_.coefficients.kernel.setZero(std::min(settings.kernel_modes, prior.scalar_modes), 3);
    state_.coefficients.pca.setZero(std::min(settings.pca_modes, prior.pca_modes));
    state_.displacement = shape_.mean_displacement;
    state_.places = start;
    at_rest_ = state_;
    choose_rows(settings.vertices, context);
}

// Open vertices that see out in the template's frontal view, spread by a hash of their number.
void Follower::choose_rows(Index wanted, const Context& context) {
    constexpr std::uint32_t kKnuth = 2654435761u;  // 2^32 over the golden ratio
    std::vector<Index> open;
    for (Index i = 0; i < shape_.num_vertices(); ++i)
        if (!inner_[static_cast<std::size_t>(i)]) open.push_back(i);
    const auto stride = static_cast<std::uint32_t>(
        std::max<Index>(1, static_cast<Index>(open.size()) / std::max<Index>(1, wanted)));
    for (const Index i : open)
        if (((static_cast<std::uint32_t>(i) * kKnuth) >> 16) % stride == 0)
            row_vertices_.push_back(i);
    if (row_vertices_.empty())
        fail(Status::invalid_argument, "following a face: the template has no open skin");
    stride_ = static_cast<double>(stride);
    solver_.use_rows(row_vertices_, state_.coefficients.kernel.rows(),
                     state_.coefficients.pca.size(), context);
}

void Follower::correspond(const DepthGrid& grid, const Points& normals, double sigma_mm,
                          const Context& context) {
    const double least = std::cos((settings_.max_angle_deg + settings_.angle_ramp_deg) *
                                  kRadiansPerDegree),
                 sure = std::cos((settings_.max_angle_deg - settings_.angle_ramp_deg) *
                                 kRadiansPerDegree);
    const double scale_mm = settings_.robust_factor * sigma_mm;
    hits_.resize(row_vertices_.size());
    weights_.setZero(static_cast<Index>(row_vertices_.size()));
    parallel_for(context, hits_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Index v = row_vertices_[k];
            const Vector3 place = state_.places.row(v).transpose();
            const double cosine_to_camera = -normals.row(v).dot(state_.places.row(v));
            hits_[k] = cosine_to_camera > 0 ? grid.look(place) : GridHit();
            const GridHit& hit = hits_[k];
            if (!hit.valid) continue;
            const double distance_mm = (hit.point - place).norm();
            if (distance_mm > settings_.reach_mm) continue;
            weights_[static_cast<Index>(k)] =
                hit.whole * robust_weight(RobustWeight::welsch, distance_mm, scale_mm) *
                fade((normals.row(v).dot(hit.normal) - least) / (sure - least));
        }
    });
}

// Point to plane of the head's motion alone (Chen and Medioni, Object modelling by registration of
// multiple range images, 1992): nothing holds places along the skin, so that the few features of a
// smooth face turn it.
void Follower::move_rigidly(const DepthGrid& grid, double sigma_mm, const Context& context) {
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    constexpr double kDamping = 1e-6;  // of the largest diagonal: a ball's turns have no equation
    for (int round = 0; round < settings_.motion_rounds; ++round) {
        const Points normals = vertex_normals(state_.places, shape_.template_mesh.triangles);
        correspond(grid, normals, sigma_mm, context);
        Vector3 centre = Vector3::Zero();
        double total = 0;
        for (std::size_t k = 0; k < hits_.size(); ++k) {
            const double weight = weights_[static_cast<Index>(k)];
            centre += weight * state_.places.row(row_vertices_[k]).transpose();
            total += weight;
        }
        if (!(total > 0)) return;
        centre /= total;
        Matrix6 system = Matrix6::Zero();
        Vector6 pull = Vector6::Zero();
        double squares = 0;
        for (std::size_t k = 0; k < hits_.size(); ++k) {
            const double weight = weights_[static_cast<Index>(k)];
            if (!(weight > 0)) continue;
            const Vector3 off = state_.places.row(row_vertices_[k]).transpose() - centre;
            Vector6 row;
            row << off.cross(hits_[k].normal), hits_[k].normal;
            system += weight * row * row.transpose();
            pull += weight * hits_[k].normal.dot(hits_[k].point - centre - off) * row;
            squares += weight * off.squaredNorm();
        }
        system.diagonal().array() += kDamping * system.diagonal().maxCoeff();
        const Eigen::LDLT<Matrix6> factor(system);
        const Vector6 step = factor.solve(pull);
        if (factor.info() != Eigen::Success || !step.allFinite()) return;
        const double angle = step.head<3>().norm();
        Similarity motion;
        if (angle > 0)
            motion.rotation = Eigen::AngleAxisd(angle, step.head<3>() / angle).toRotationMatrix();
        motion.translation = centre + step.tail<3>() - motion.rotation * centre;
        state_.motion = compose(motion, state_.motion);
        state_.places = motion.apply(state_.places);
        if (angle * std::sqrt(squares / total) + step.tail<3>().norm() < settings_.still_mm) return;
    }
}

void Follower::run_rounds(const DepthGrid& grid, int rounds, double sigma_start_mm, bool remember,
                          const Context& context) {
    const Points& rest = shape_.template_mesh.vertices;
    const Points before = state_.displacement;
    FitStepOptions step;
    step.scalar_modes = state_.coefficients.kernel.rows();
    step.pca_modes = state_.coefficients.pca.size();
    step.kernel_ridge = 1 / (state_.kernel_amplitude * state_.kernel_amplitude);
    step.pca_ridge = 1 / (freedom_.pca_amplitude * freedom_.pca_amplitude);
    step.move = freedom_.move;
    step.scale = false;  // a head does not grow
    step.solver = settings_.solver;
    move_rigidly(grid, sigma_start_mm, context);
    FitTerms terms;
    Points current(static_cast<Index>(row_vertices_.size()), 3);
    for (int round = 0; round < rounds; ++round) {
        const double f = rounds > 1 ? static_cast<double>(round) / (rounds - 1) : 1;
        const double sigma_mm =
            sigma_start_mm * std::pow(settings_.sigma_end_mm / sigma_start_mm, f);
        const Points normals = vertex_normals(state_.places, shape_.template_mesh.triangles);
        correspond(grid, normals, sigma_mm, context);
        const Similarity to_model = state_.motion.inverse();
        const double precision = settings_.weight * stride_ / (sigma_mm * sigma_mm);
        const double kept =
            remember && settings_.temporal_mm > 0
                ? settings_.weight * stride_ / (settings_.temporal_mm * settings_.temporal_mm)
                : 0;
        terms.reset(current.rows());
        for (Index row = 0; row < current.rows(); ++row) {
            const std::size_t k = static_cast<std::size_t>(row);
            const Index v = row_vertices_[k];
            const Vector3 mean = shape_.mean_displacement.row(v).transpose(),
                          here = rest.row(v).transpose() + mean;
            current.row(row) = rest.row(v) + state_.displacement.row(v);
            if (weights_[row] > 0)
                terms.add_planar(row, weights_[row] * precision, settings_.tangential,
                                 to_model.rotation * hits_[k].normal,
                                 to_model.apply(hits_[k].point) - here);
            if (kept > 0) terms.add_isotropic(row, kept, before.row(v).transpose() - mean);
        }
        const Similarity motion = solver_.step(terms, current, step, state_.coefficients, context);
        state_.motion = compose(state_.motion, motion);
        state_.displacement = solver_.displacement(state_.coefficients, context);
        state_.places = state_.motion.apply(PointsRef(Points(rest + state_.displacement)));
    }
}

// Of the vertices that the camera could see, those that lie on what it saw.
Follower::Sight Follower::look(const DepthGrid& grid, const Context& context) const {
    struct Count {
        Index facing = 0, near = 0;
        double distance_mm = 0;
        Count& operator+=(const Count& other) {
            facing += other.facing;
            near += other.near;
            distance_mm += other.distance_mm;
            return *this;
        }
    };
    const Points normals = vertex_normals(state_.places, shape_.template_mesh.triangles);
    const double sure = std::cos(settings_.max_angle_deg * kRadiansPerDegree);
    const Count count = parallel_sum<Count>(
        context, row_vertices_.size(), kChunk, Count(), [&](std::size_t begin, std::size_t end) {
            Count part;
            for (std::size_t k = begin; k < end; ++k) {
                const Index v = row_vertices_[k];
                const Vector3 place = state_.places.row(v).transpose();
                const double to_camera = -normals.row(v).dot(place.transpose());
                if (!(to_camera > sure * place.norm())) continue;
                ++part.facing;
                if (!grid.in_view(place)) continue;
                const GridHit hit = grid.look(place);
                const double distance_mm = (hit.point - place).norm();
                if (!hit.valid || distance_mm > settings_.near_mm ||
                    normals.row(v).dot(hit.normal) < sure)
                    continue;
                ++part.near;
                part.distance_mm += distance_mm;
            }
            return part;
        });
    if (count.facing == 0 || count.near == 0) return {0, 0};
    return {static_cast<double>(count.near) / static_cast<double>(count.facing),
            count.distance_mm / static_cast<double>(count.near)};
}

// Begins anew from the pose that a search over the whole frame finds.
bool Follower::search(const DepthGrid& grid, const Context& context) {
    TriMesh mesh;
    grid.to_mesh(mesh.vertices, mesh.triangles);
    if (mesh.triangles.rows() < settings_.grid.fewest_points) return false;
    ScanSurfaceSettings plain;
    plain.smoothing_mm = 0;
    const ScanSurface surface = build_scan_surface(mesh, plain, context);
    SearchResult found;
    try {
        found = search_pose(shape_, surface, settings_.search, context);
    } catch (const Error& error) {
        if (error.status() != Status::no_solution) throw;
        return false;  // nothing in the frame, or in the template, faces a viewer
    }
    if (!(found.score >= settings_.found_score)) return false;
    state_ = at_rest_;
    state_.motion = found.motion;
    state_.places =
        state_.motion.apply(PointsRef(Points(shape_.template_mesh.vertices + state_.displacement)));
    run_rounds(grid, settings_.rounds_found, settings_.sigma_found_mm, false, context);
    return true;
}

double Follower::slide_mm() const {
    const Points rest = shape_.template_mesh.vertices + shape_.mean_displacement;
    const Points normals = vertex_normals(rest, shape_.template_mesh.triangles);
    std::vector<double> ways;
    ways.reserve(row_vertices_.size());
    for (const Index v : row_vertices_) {
        const Vector3 way =
            (state_.displacement.row(v) - shape_.mean_displacement.row(v)).transpose();
        const Vector3 normal = normals.row(v).transpose();
        ways.push_back((way - normal * normal.dot(way)).norm());
    }
    const auto middle = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 2);
    std::nth_element(ways.begin(), middle, ways.end());
    return *middle;
}

FollowedFrame Follower::follow(const DepthGrid& grid, const Context& context) {
    const FitState before = state_;
    FollowedFrame frame;
    Sight sight{0, 0};
    if (!lost_) {
        run_rounds(grid, settings_.rounds, settings_.sigma_start_mm, true, context);
        sight = look(grid, context);
    }
    const bool searched = sight.share < settings_.lost_share;
    if (searched) {
        if (search(grid, context)) sight = look(grid, context);
        lost_ = sight.share < settings_.lost_share;
        if (lost_) state_ = before;
    }
    frame.share = sight.share;
    frame.residual_mm = sight.residual_mm;
    frame.slide_mm = slide_mm();
    frame.motion = state_.motion;
    if (lost_)
        frame.state = FollowState::lost;
    else if (searched)
        frame.state = FollowState::found_again;
    else if (sight.share < settings_.doubtful_share || frame.slide_mm > settings_.doubtful_slide_mm)
        frame.state = FollowState::doubtful;
    else
        frame.state = FollowState::followed;
    return frame;
}

}  // namespace mien
