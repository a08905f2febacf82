#include "expression/placed_fit.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "base/scalar_math.hpp"
#include "geometry/alignment.hpp"

namespace mien {
namespace {

constexpr int kPoseRounds = 8;
constexpr double kSettledMm = 1e-3;  ///< a pose that moves no more
constexpr int kDoubtRounds = 4;
constexpr double kDoubtScale = 1.2;     ///< k, of the residual that 95 % of new people stay under
constexpr double kFlexibleShare = 0.1;  ///< noise of the flexible fit, of the model's
constexpr double kMaxNoiseFactor =
    100.0;                          ///< for faces that are worse than the training's all over
constexpr double kTurnUnit = 0.01;  ///< rad per unit of a turn coordinate: a millimetre or so
constexpr double kFarTurnDegrees = 3.0, kFarShiftMm = 8.0;  ///< a motion worth a rigid fit
constexpr double kPoseVariance = 100.0;  ///< wide; keeps the system definite when little is visible

using Pose6 = Eigen::Matrix<double, 6, 1>;

Similarity align_weighted(const PointsRef& from, const PointsRef& to, const Vector& weights) {
    if (weights.size() == 0) return align_points(from, to, weights, false);
    // Rows of weight zero may hold anything, which a product with zero would not silence.
    Points seen = from;
    for (Index i = 0; i < weights.size(); ++i)
        if (weights[i] == 0.0) seen.row(i) = to.row(i);
    return align_points(seen, to, weights, false);
}

Similarity align_stable(const ExpressionModel& model, const PointsRef& vertices) {
    const Index count = static_cast<Index>(model.stable_vertices.size());
    Points from(count, 3), to(count, 3);
    for (Index k = 0; k < count; ++k) {
        from.row(k) = vertices.row(model.stable_vertices[static_cast<std::size_t>(k)]);
        to.row(k) = model.mean.row(model.stable_vertices[static_cast<std::size_t>(k)]);
    }
    return align_points(from, to, Vector(), false);
}

bool is_far(const Similarity& motion, const PointsRef& mean) {
    const double cosine = std::min(1.0, std::max(-1.0, 0.5 * (motion.rotation.trace() - 1.0)));
    const Vector3 centre = mean.colwise().mean();
    return std::acos(cosine) > kFarTurnDegrees * kRadiansPerDegree ||
           (motion.apply(centre) - centre).norm() > kFarShiftMm;
}

bool identity_motion(const Similarity& motion) {
    return motion.rotation == Matrix3::Identity() && motion.translation == Vector3::Zero();
}

/// The normal equations of one face in (c, g), where g is empty for a face whose pose is known.
struct Equations {
    FaceEvidence modes;
    Matrix cross;  ///< B' W Z
    Matrix turn;   ///< Z' W Z, with the prior of the pose
    Vector pull;   ///< Z' W (v - mean)
    double energy = 0, total = 0;
};

class FaceFitter {
  public:
    FaceFitter(const Context& context, const ExpressionModel& model, const PointsRef& vertices,
               const Vector& weights, const FitOptions& options)
        : context_(context),
          model_(model),
          vertices_(vertices),
          given_(weights),
          options_(options),
          centre_(model.mean.colwise().mean()) {}

    /// In the frame given, or with a pose fitted from there on.
    PlacedFit fit(const Similarity& start, bool free_pose) const {
        PlacedFit placed;
        placed.to_model = start;
        placed.noise_mm2 = has_prior() ? own_noise() : 0.0;
        for (int round = 0; round < (free_pose ? kPoseRounds : 1); ++round)
            if (step(placed, given_, free_pose) < kSettledMm) break;
        return placed;
    }

    /// Doubts what nothing explains, if the face is farther from its fit than new people's faces
    /// are.
    void doubt(PlacedFit& placed, bool free_pose) const {
        const double expected = model_.expected_residual_mm;
        if (!has_prior() || options_.noise_mm2 > 0.0 || !(expected > 0.0) ||
            placed.residual_rms_mm <= expected)
            return;
        Vector weights = given_.size() != 0 ? given_ : Vector(Vector::Ones(model_.num_vertices()));
        const double all = weights.sum();
        for (int round = 0; round < kDoubtRounds; ++round) {
            context_.check_cancelled();
            const Vector distance = flexible_step(placed.to_model, weights, free_pose);
            for (Index i = 0; i < weights.size(); ++i) {
                const double given = given_.size() != 0 ? given_[i] : 1.0;
                const double ratio = given == 0.0 ? 0.0 : distance[i] / (kDoubtScale * expected);
                weights[i] = given / ((1.0 + ratio * ratio) * (1.0 + ratio * ratio));
            }
        }
        placed.noise_mm2 = own_noise();
        step(placed, weights, free_pose);
        // What is left all over the face is error that the modes could not even absorb: they
        // absorbed the larger part of it, so that the noise has to grow faster than the square of
        // what is left to see.
        const double excess = placed.residual_rms_mm / expected;
        if (excess > 1.0) {
            placed.noise_mm2 *= std::min(kMaxNoiseFactor, excess * excess * excess * excess);
            step(placed, weights, free_pose);
        }
        placed.doubted_share = 1.0 - weights.sum() / all;
        placed.residual_rms_mm = root_mean_square(
            distances(placed.to_model.apply(vertices_), along(placed.fit), Vector(), given_),
            given_);
    }

  private:
    bool has_prior() const {
        return options_.method == FitMethod::mixture || options_.method == FitMethod::map;
    }
    double own_noise() const {
        if (options_.noise_mm2 > 0.0) return options_.noise_mm2;
        return options_.method == FitMethod::mixture ? model_.mixture_noise_mm2
                                                     : model_.map_noise_mm2;
    }
    Vector along(const FitResult& fit) const {
        return mode_coordinates(model_, options_.method, fit.identity, fit.expression);
    }

    /// Column k of Z.
    Vector motion(int k) const {
        const Index n = model_.num_vertices();
        Vector column(3 * n);
        const Vector3 axis = Vector3::Unit(k % 3);
        for (Index i = 0; i < n; ++i)
            column.segment<3>(3 * i) =
                k < 3 ? axis
                      : Vector3(kTurnUnit * axis.cross(model_.mean.row(i).transpose() - centre_));
        return column;
    }

    Equations gather(const Points& moved, const Vector& weights, bool free_pose) const {
        const Index n = model_.num_vertices(), p = model_.num_identity_modes();
        const Index q = model_.num_expression_modes();
        Equations equations;
        equations.modes = gather_evidence(context_, model_, moved, weights);
        Vector displacement = Vector::Zero(3 * n);
        for (Index i = 0; i < n; ++i) {
            const double weight = weights.size() != 0 ? weights[i] : 1.0;
            if (weight == 0.0) continue;
            displacement.segment<3>(3 * i) = moved.row(i) - model_.mean.row(i);
            equations.energy += weight * displacement.segment<3>(3 * i).squaredNorm();
            equations.total += weight;
        }
        if (!free_pose) return equations;
        equations.cross.resize(p + q, 6);
        equations.turn.resize(6, 6);
        equations.pull.resize(6);
        Matrix plain(3 * n, 6), weighted(3 * n, 6);
        for (int k = 0; k < 6; ++k) {
            plain.col(k) = motion(k);
            weighted.col(k) = plain.col(k);
            if (weights.size() != 0)
                for (Index row = 0; row < 3 * n; ++row) weighted(row, k) *= weights[row / 3];
            equations.cross.col(k).head(p) =
                project_modes(context_, model_.identity_modes, weighted.col(k));
            equations.cross.col(k).tail(q) =
                project_modes(context_, model_.expression_modes, weighted.col(k));
        }
        equations.turn = weighted.transpose() * plain;
        equations.turn.diagonal().array() += own_noise() / kPoseVariance;
        equations.pull = weighted.transpose() * displacement;
        return equations;
    }

    static Eigen::LDLT<Matrix> factor_turn(const Equations& equations) {
        Eigen::LDLT<Matrix> turn(equations.turn);
        if (turn.info() != Eigen::Success)
            fail(Status::no_solution, "the face's pose is not determined by what is visible");
        return turn;
    }

    /// The same evidence with every pose already weighed in.
    FaceEvidence without_pose(const Equations& equations) const {
        if (equations.cross.size() == 0) return equations.modes;
        const Eigen::LDLT<Matrix> turn = factor_turn(equations);
        FaceEvidence evidence;
        evidence.projection =
            equations.modes.projection - equations.cross * turn.solve(equations.pull);
        const Matrix& gram = equations.modes.gram.size() != 0 ? equations.modes.gram : model_.gram;
        evidence.gram = gram - equations.cross * turn.solve(equations.cross.transpose());
        evidence.gram = (0.5 * (evidence.gram + evidence.gram.transpose())).eval();
        return evidence;
    }

    Vector pose_of(const Equations& equations, const Vector& coordinates) const {
        if (equations.cross.size() == 0) return Vector();
        const Eigen::LDLT<Matrix> turn = factor_turn(equations);
        return turn.solve(equations.pull - equations.cross.transpose() * coordinates);
    }

    /// Moves the pose so that g would be zero; returns by how much, in millimetres or so.
    double turn_back(Similarity& to_model, const Vector& g) const {
        if (g.size() == 0) return 0.0;
        const Vector3 turn = kTurnUnit * g.tail<3>();
        const double angle = turn.norm();
        const Matrix3 back = angle > 0.0
                                 ? Eigen::AngleAxisd(-angle, turn / angle).toRotationMatrix()
                                 : Matrix3::Identity();
        to_model.translation = back * (to_model.translation - centre_ - g.head<3>()) + centre_;
        to_model.rotation = back * to_model.rotation;
        return g.norm();
    }

    /// One fit; the pose follows.
    double step(PlacedFit& placed, const Vector& weights, bool free_pose) const {
        const Points moved =
            identity_motion(placed.to_model) ? Points(vertices_) : placed.to_model.apply(vertices_);
        const Equations equations = gather(moved, weights, free_pose);
        FitOptions options = options_;
        if (has_prior()) options.noise_mm2 = placed.noise_mm2;
        placed.fit = fit_face(model_, without_pose(equations), options);
        const Vector coordinates = along(placed.fit), g = pose_of(equations, coordinates);
        if (g.size() != 0) {
            placed.residual_rms_mm =
                root_mean_square(distances(moved, coordinates, g, weights), weights);
        } else {  // from the small matrices alone
            const Matrix& gram =
                equations.modes.gram.size() != 0 ? equations.modes.gram : model_.gram;
            const double rest =
                equations.energy +
                coordinates.dot(gram * coordinates - 2.0 * equations.modes.projection);
            placed.residual_rms_mm =
                equations.total > 0.0 ? std::sqrt(std::max(0.0, rest) / equations.total) : 0.0;
        }
        return turn_back(placed.to_model, g);
    }

    /// The fit that explains most: all expressions at once and little noise. Returns what it
    /// leaves.
    Vector flexible_step(Similarity& to_model, const Vector& weights, bool free_pose) const {
        const Points moved =
            identity_motion(to_model) ? Points(vertices_) : to_model.apply(vertices_);
        const Equations equations = gather(moved, weights, free_pose);
        const FaceEvidence evidence = without_pose(equations);
        const double noise = kFlexibleShare * own_noise();
        const Matrix& gram = evidence.gram.size() != 0 ? evidence.gram : model_.gram;
        Matrix system = model_.spill.pull_gram(gram);
        const Index p = model_.num_identity_modes(), q = model_.num_expression_modes();
        system.topLeftCorner(p, p) += noise * model_.identity_precision();
        system.diagonal().tail(q) +=
            noise * model_.expression_deviations.array().square().inverse().matrix();
        const Eigen::LDLT<Matrix> factor(system);
        if (factor.info() != Eigen::Success)
            fail(Status::no_solution, "the face cannot be fitted freely: its data are damaged");
        const Vector solved = factor.solve(model_.spill.pull_vector(evidence.projection));
        const Vector coordinates = model_.spill.along_modes(solved.head(p), solved.tail(q));
        const Vector g = pose_of(equations, coordinates);
        Vector left = distances(moved, coordinates, g, weights);
        turn_back(to_model, g);
        return left;
    }

    /// | v - mean - B c - Z g | per vertex; zero where there is no data.
    Vector distances(const Points& moved, const Vector& coordinates, const Vector& g,
                     const Vector& weights) const {
        const Index n = model_.num_vertices(), p = model_.num_identity_modes();
        const Index q = model_.num_expression_modes();
        Vector made = Vector::Zero(3 * n);
        add_modes(context_, model_.identity_modes, coordinates.head(p), made);
        add_modes(context_, model_.expression_modes, coordinates.tail(q), made);
        for (int k = 0; k < g.size(); ++k) made += g[k] * motion(k);
        Vector distance = Vector::Zero(n);
        for (Index i = 0; i < n; ++i)
            if (weights.size() == 0 || given_.size() == 0 || given_[i] != 0.0)
                distance[i] =
                    (moved.row(i) - model_.mean.row(i) - made.segment<3>(3 * i).transpose()).norm();
        return distance;
    }

    static double root_mean_square(const Vector& distance, const Vector& weights) {
        if (weights.size() == 0)
            return std::sqrt(distance.squaredNorm() / static_cast<double>(distance.size()));
        const double total = weights.sum();
        return total > 0.0 ? std::sqrt(weights.dot(distance.cwiseAbs2()) / total) : 0.0;
    }

    const Context& context_;
    const ExpressionModel& model_;
    const PointsRef& vertices_;
    const Vector& given_;
    const FitOptions& options_;
    const Vector3 centre_;
};

}  // namespace

PlacedFit place_and_fit(const Context& context, const ExpressionModel& model,
                        const PointsRef& vertices, const Vector& weights, const FitOptions& options,
                        Pose pose) {
    const FaceFitter fitter(context, model, vertices, weights, options);
    PlacedFit placed;
    bool free_pose = pose == Pose::rigid;
    if (pose == Pose::keep) {
        placed = fitter.fit(Similarity(), false);
    } else if (pose == Pose::automatic && !model.stable_vertices.empty()) {
        placed = fitter.fit(align_stable(model, vertices), false);
    } else {
        const Similarity start = align_weighted(vertices, model.mean, weights);
        if (!free_pose) {
            placed = fitter.fit(Similarity(), false);
            // A wide open mouth may look like a turned head at first; what the model cannot explain
            // decides.
            if (is_far(start, model.mean)) {
                PlacedFit moved = fitter.fit(start, true);
                free_pose = moved.residual_rms_mm < 0.6 * placed.residual_rms_mm;
                if (free_pose) placed = std::move(moved);
            }
        } else {
            placed = fitter.fit(start, true);
        }
    }
    fitter.doubt(placed, free_pose);
    return placed;
}

}  // namespace mien
