#include "expression/visits.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <limits>

#include "base/error.hpp"
#include "geometry/normals.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

constexpr Index kSpeakers = 3000;  ///< vertices that enter the normal equations, about
constexpr int kPoseSteps = 2;   ///< solutions before the last, each followed by a step of the poses
constexpr double kFarMm = 2.0;  ///< off the common face: no witness of the pose
constexpr double kLargestSlideMm = 5.0;  ///< a foot farther off is on another part of the face
constexpr std::size_t kCandidates = 3;   ///< mixture components tried per visit

/// Weight of a visit's vertices; a treated vertex says nothing about the expression.
Vector speaking_weights(const VisitFace& face, Index n, const std::vector<std::uint32_t>& treated) {
    Vector weights = face.weights.size() != 0 ? face.weights : Vector(Vector::Ones(n));
    for (const std::uint32_t vertex : treated) weights[vertex] = 0.0;
    return weights;
}

/// [P + Q R, Q + P T] at some vertices, three rows each.
Matrix mode_rows(const ExpressionModel& model, const std::vector<Index>& speakers) {
    const Index p = model.num_identity_modes(), q = model.num_expression_modes();
    Matrix rows(3 * static_cast<Index>(speakers.size()), p + q);
    for (std::size_t k = 0; k < speakers.size(); ++k) {
        const Index row = 3 * static_cast<Index>(k);
        rows.block(row, 0, 3, p) =
            model.identity_modes.map().middleRows(3 * speakers[k], 3).cast<double>();
        rows.block(row, p, 3, q) =
            model.expression_modes.map().middleRows(3 * speakers[k], 3).cast<double>();
    }
    if (!model.spill.empty()) {
        const Matrix plain = rows;
        rows.leftCols(p) += plain.rightCols(q) * model.spill.identity;
        rows.rightCols(q) += plain.leftCols(p) * model.spill.expression;
    }
    return rows;
}

class VisitsFit {
  public:
    VisitsFit(const Context& context, const ExpressionModel& model,
              const std::vector<VisitFace>& faces, const VisitsOptions& options)
        : context_(context),
          model_(model),
          options_(options),
          count_(static_cast<Index>(faces.size())),
          p_(model.num_identity_modes()),
          q_(model.num_expression_modes()) {
        const Index n = model.num_vertices(), stride = std::max<Index>(1, n / kSpeakers);
        for (const VisitFace& face : faces)
            weights_.push_back(speaking_weights(face, n, options.treated));
        for (Index v = 0; v < n; v += stride) speakers_.push_back(v);
        for (Vector& weights : weights_) weights *= static_cast<double>(stride);
        modes_ = mode_rows(model, speakers_);
    }

    /// Every face by itself: where it lies, and which expressions come into question.
    void start(const std::vector<VisitFace>& faces) {
        Context quiet = context_;
        quiet.progress_function = nullptr;
        for (std::size_t k = 0; k < faces.size(); ++k) {
            NeutralizeOptions single;
            single.pose = options_.pose;
            const NeutralizationResult alone =
                neutralize(quiet, model_, faces[k].vertices, weights_[k], single);
            poses.push_back(alone.pose);
            placed.push_back(alone.pose.inverse().apply(PointsRef(faces[k].vertices)));
            std::vector<std::size_t> order(alone.component_probabilities.size());
            for (std::size_t c = 0; c < order.size(); ++c) order[c] = c;
            std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
                return alone.component_probabilities[a] > alone.component_probabilities[b];
            });
            order.resize(std::min(order.size(), kCandidates));
            chosen.push_back(order.empty() ? 0 : order[0]);
            candidates_.push_back(std::move(order));
            context_.progress(Stage::neutralizing,
                              0.5 * static_cast<double>(k + 1) / static_cast<double>(faces.size()));
        }
    }

    void solve() {
        for (int step = 0;; ++step) {
            gather();
            choose_components();
            context_.progress(Stage::neutralizing, 0.5 + 0.15 * (step + 1));
            if (step == kPoseSteps) return;
            for (Index k = 0; k < count_; ++k) move(k);
        }
    }

    Vector expression(Index k) const { return solution_.coordinates.segment(p_ + k * q_, q_); }
    Matrix covariance() const {
        Matrix matrix = prior_added(chosen);
        const Eigen::LLT<Matrix> factor(matrix);
        return factor.solve(Matrix::Identity(matrix.rows(), matrix.cols()))
            .bottomRightCorner(count_ * q_, count_ * q_);
    }

    std::vector<Points> placed;       ///< per visit, in the training's frame
    std::vector<Similarity> poses;    ///< training frame -> frame of the face
    std::vector<std::size_t> chosen;  ///< mixture component of each visit

  private:
    struct Solution {
        Vector coordinates;
        double log_evidence = -std::numeric_limits<double>::infinity();
    };
    bool mixture() const { return !model_.components.empty(); }
    const FitPlan::Part& part(std::size_t component) const {
        return mixture() ? model_.plan->components[component] : model_.plan->map;
    }

    /// The normal equations without the expressions' priors, and what is needed of the common face
    /// d.
    void gather() {
        const Index size = p_ + count_ * q_, m = static_cast<Index>(speakers_.size());
        precision_.assign(static_cast<std::size_t>(count_ * m), Matrix3::Zero());
        common_.assign(static_cast<std::size_t>(m), Matrix3::Identity() / shared_noise());
        for (Index k = 0; k < count_; ++k) {
            const Points normals =
                vertex_normals(placed[static_cast<std::size_t>(k)], model_.triangles);
            for (Index i = 0; i < m; ++i) {
                const Index v = speakers_[static_cast<std::size_t>(i)];
                const Vector3 normal = normals.row(v);
                const double weight = weights_[static_cast<std::size_t>(k)][v];
                const double across = weight / options_.tangential_noise_mm2,
                             along = weight / options_.normal_noise_mm2;
                Matrix3& own = precision_[static_cast<std::size_t>(k * m + i)];
                own = across * Matrix3::Identity() + (along - across) * normal * normal.transpose();
                common_[static_cast<std::size_t>(i)] += own;
            }
        }
        for (Matrix3& block : common_) block = block.inverse().eval();
        data_ = Matrix::Zero(size, size);
        right_ = Vector::Zero(size);
        data_.diagonal().head(p_) = model_.identity_deviations.array().square().inverse();
        Matrix coupled(modes_.rows(), modes_.cols());
        Vector pulled(modes_.rows());
        for (Index k = 0; k < count_; ++k)
            for (Index l = 0; l < count_; ++l) {
                context_.check_cancelled();
                const Points& face = placed[static_cast<std::size_t>(l)];
                for (Index i = 0; i < m; ++i) {
                    const Matrix3 block = coupling(k, l, i);
                    const Index v = speakers_[static_cast<std::size_t>(i)];
                    pulled.segment<3>(3 * i) =
                        block * (face.row(v) - model_.mean.row(v)).transpose();
                    if (l >= k)
                        coupled.middleRows(3 * i, 3).noalias() =
                            block * modes_.middleRows(3 * i, 3);
                }
                const Vector along = modes_.transpose() * pulled;
                right_.head(p_) += along.head(p_);
                right_.segment(p_ + k * q_, q_) += along.tail(q_);
                if (l < k) continue;
                const Matrix gram = modes_.transpose() * coupled;
                add(k, l, gram);
                if (l != k) add(l, k, gram.transpose());
            }
        data_.bottomLeftCorner(count_ * q_, p_) = data_.topRightCorner(p_, count_ * q_).transpose();
    }
    double shared_noise() const {
        return mixture() ? model_.mixture_noise_mm2 : model_.map_noise_mm2;
    }
    Matrix3 coupling(Index k, Index l, Index i) const {
        const Index m = static_cast<Index>(speakers_.size());
        const Matrix3& left = precision_[static_cast<std::size_t>(k * m + i)];
        const Matrix3& right = precision_[static_cast<std::size_t>(l * m + i)];
        Matrix3 block = -left * common_[static_cast<std::size_t>(i)] * right;
        if (k == l) block += left;
        return block;
    }
    void add(Index k, Index l, const Matrix& gram) {
        data_.topLeftCorner(p_, p_) += gram.topLeftCorner(p_, p_);
        data_.block(0, p_ + l * q_, p_, q_) += gram.topRightCorner(p_, q_);
        data_.block(p_ + k * q_, p_ + l * q_, q_, q_) += gram.bottomRightCorner(q_, q_);
    }

    Matrix prior_added(const std::vector<std::size_t>& choice) const {
        Matrix matrix = data_;
        for (Index k = 0; k < count_; ++k)
            matrix.block(p_ + k * q_, p_ + k * q_, q_, q_) +=
                part(choice[static_cast<std::size_t>(k)]).prior_precision;
        return matrix;
    }
    Solution solve_with(const std::vector<std::size_t>& choice) const {
        Vector right = right_;
        double offset = 0.0;
        for (Index k = 0; k < count_; ++k) {
            const FitPlan::Part& prior = part(choice[static_cast<std::size_t>(k)]);
            const Vector pull = prior.prior_precision * prior.mean.tail(q_);
            right.segment(p_ + k * q_, q_) += pull;
            const Eigen::LLT<Matrix> factor(prior.prior_precision);
            offset += factor.matrixLLT().diagonal().array().log().sum() -
                      0.5 * prior.mean.tail(q_).dot(pull);
            if (mixture())
                offset += std::log(model_.components[choice[static_cast<std::size_t>(k)]].weight);
        }
        const Eigen::LLT<Matrix> factor(prior_added(choice));
        if (factor.info() != Eigen::Success)
            fail(Status::no_solution,
                 "the joint fit of the visits is singular: too little of the faces is visible");
        Solution solution;
        solution.coordinates = factor.solve(right);
        solution.log_evidence = offset + 0.5 * solution.coordinates.dot(right) -
                                factor.matrixLLT().diagonal().array().log().sum();
        return solution;
    }
    void choose_components() {
        solution_ = solve_with(chosen);
        for (bool improved = mixture(); improved;) {
            improved = false;
            for (std::size_t k = 0; k < chosen.size(); ++k)
                for (const std::size_t candidate : candidates_[k]) {
                    context_.check_cancelled();
                    if (candidate == chosen[k]) continue;
                    std::vector<std::size_t> trial = chosen;
                    trial[k] = candidate;
                    Solution solution = solve_with(trial);
                    if (!(solution.log_evidence > solution_.log_evidence)) continue;
                    solution_ = std::move(solution);
                    chosen = std::move(trial);
                    improved = true;
                }
        }
    }

    /// Turns and shifts visit k onto the common face with its expression, along the normals.
    void move(Index k) {
        const Index m = static_cast<Index>(speakers_.size());
        Points& face = placed[static_cast<std::size_t>(k)];
        const Points normals = vertex_normals(face, model_.triangles);
        const Vector identity = modes_.leftCols(p_) * solution_.coordinates.head(p_);
        std::vector<Vector> rest;  // face less identity and expression, of every visit
        for (Index l = 0; l < count_; ++l) {
            Vector own = -identity - modes_.rightCols(q_) * expression(l);
            for (Index i = 0; i < m; ++i) {
                const Index v = speakers_[static_cast<std::size_t>(i)];
                own.segment<3>(3 * i) +=
                    (placed[static_cast<std::size_t>(l)].row(v) - model_.mean.row(v)).transpose();
            }
            rest.push_back(std::move(own));
        }
        const Vector3 centre = model_.mean.colwise().mean();
        Eigen::Matrix<double, 6, 6> system = Eigen::Matrix<double, 6, 6>::Zero();
        Eigen::Matrix<double, 6, 1> pull = Eigen::Matrix<double, 6, 1>::Zero();
        double total = 0.0;
        for (Index i = 0; i < m; ++i) {
            const Index v = speakers_[static_cast<std::size_t>(i)];
            Vector3 common = Vector3::Zero();  // d
            for (Index l = 0; l < count_; ++l)
                common += precision_[static_cast<std::size_t>(l * m + i)] *
                          rest[static_cast<std::size_t>(l)].segment<3>(3 * i);
            common = common_[static_cast<std::size_t>(i)] * common;
            const Vector3 normal = normals.row(v);
            const double off =
                normal.dot(Vector3(rest[static_cast<std::size_t>(k)].segment<3>(3 * i)) - common);
            const double ratio = off / kFarMm;
            if (!(std::fabs(ratio) < 1)) continue;
            const double weight = weights_[static_cast<std::size_t>(k)][v] * (1 - ratio * ratio) *
                                  (1 - ratio * ratio);
            Eigen::Matrix<double, 6, 1> row;
            row << (Vector3(face.row(v)) - centre).cross(normal), normal;
            system += weight * row * row.transpose();
            pull += weight * off * row;
            total += weight;
        }
        if (!(total > 0)) return;
        system.diagonal().array() += 1e-9 * system.trace();
        const Eigen::Matrix<double, 6, 1> step = -system.ldlt().solve(pull);
        const double angle = step.head<3>().norm();
        Matrix3 turn = Matrix3::Identity();
        if (angle > 0)
            turn = Eigen::AngleAxisd(angle, Vector3(step.head<3>()) / angle).toRotationMatrix();
        Similarity motion;
        motion.rotation = turn;
        motion.translation = centre - turn * centre + step.tail<3>();
        face = motion.apply(PointsRef(face));
        Similarity& pose = poses[static_cast<std::size_t>(k)];  // pose o motion^-1
        const Matrix3 rotation = pose.rotation * turn.transpose();
        pose.translation -= pose.scale * (rotation * motion.translation);
        pose.rotation = rotation;
    }

    const Context& context_;
    const ExpressionModel& model_;
    const VisitsOptions& options_;
    Index count_, p_, q_;
    std::vector<Vector> weights_;
    std::vector<Index> speakers_;
    Matrix modes_;
    std::vector<std::vector<std::size_t>> candidates_;
    std::vector<Matrix3> precision_, common_;
    Matrix data_;
    Vector right_;
    Solution solution_;
};

/// `neutral` with each vertex where the person's own face says it is: the foot of base + moved on
/// the face.
Points without_slide(const Context& context, const Points& base, const Points& moved,
                     const Points& face, const TrianglesRef& triangles, const Vector& seen_first,
                     const Vector& seen) {
    const Points expected = base + moved;
    const TriangleTree tree(face, triangles, context);
    std::vector<SurfaceHit> feet;
    tree.closest(expected, std::numeric_limits<double>::infinity(), feet, context);
    const Points normals = vertex_normals(face, triangles),
                 flat = triangle_normals(face, triangles);
    Points neutral = face - moved;
    for (Index v = 0; v < face.rows(); ++v) {
        const SurfaceHit& foot = feet[static_cast<std::size_t>(v)];
        const double share = std::min(
            {1.0, seen_first.size() != 0 ? seen_first[v] : 1.0, seen.size() != 0 ? seen[v] : 1.0});
        if (!foot.valid() || !(share > 0)) continue;
        const Vector3 slide = foot.point - Vector3(face.row(v));
        // A foot on the other lip, or inside the nose, is no place of this vertex.
        if (slide.norm() > kLargestSlideMm ||
            Vector3(flat.row(foot.triangle)).dot(Vector3(normals.row(v))) <= 0)
            continue;
        neutral.row(v) += share * slide;
    }
    return neutral;
}

}  // namespace

VisitsResult neutralize_visits(const Context& context, const ExpressionModel& model,
                               const std::vector<VisitFace>& faces, const VisitsOptions& options) {
    if (faces.empty()) fail(Status::invalid_argument, "visits need at least one face");
    if (!(options.normal_noise_mm2 > 0) || !(options.tangential_noise_mm2 > 0) ||
        !std::isfinite(options.normal_noise_mm2) || !std::isfinite(options.tangential_noise_mm2))
        fail(Status::invalid_argument,
             "the visits' noise variances are %g and %g mm^2; both must be positive",
             options.normal_noise_mm2, options.tangential_noise_mm2);
    if (model.triangles.rows() == 0)
        fail(Status::invalid_argument,
             "the expression model has no triangles; visits are compared as surfaces");
    for (const VisitFace& face : faces) {
        check_face(model, face.vertices, face.weights);
        check_face(model, face.vertices, Vector());  // surfaces need every vertex
    }
    for (const std::uint32_t vertex : options.treated)
        if (vertex >= static_cast<std::uint64_t>(model.num_vertices()))
            fail(Status::mismatch, "the treated zone names vertex %u of %lld", vertex,
                 static_cast<long long>(model.num_vertices()));
    VisitsFit fit(context, model, faces, options);
    fit.start(faces);
    fit.solve();

    VisitsResult result;
    result.covariance = fit.covariance();
    Points base;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        result.expressions.push_back(fit.expression(static_cast<Index>(k)));
        if (!model.components.empty())
            result.components.push_back(model.components[fit.chosen[k]].name);
        const Vector flat = expression_displacement(context, model, result.expressions.back());
        const Points moved = Eigen::Map<const Points>(flat.data(), model.num_vertices(), 3);
        const Points neutral =
            k == 0 ? Points(fit.placed[0] - moved)
                   : without_slide(context, base, moved, fit.placed[k], model.triangles,
                                   faces[0].weights, faces[k].weights);
        if (k == 0) base = neutral;
        result.neutral_vertices.push_back(fit.poses[k].apply(PointsRef(neutral)));
        result.poses.push_back(fit.poses[k]);
    }
    context.progress(Stage::neutralizing, 1.0);
    return result;
}

RemovedVolume removed_volume(const Context& context, const ExpressionModel& model,
                             const VisitsResult& visits, std::size_t first, std::size_t second,
                             const std::vector<std::uint32_t>& zone) {
    const Index q = model.num_expression_modes(), n = model.num_vertices();
    if (first >= visits.expressions.size() || second >= visits.expressions.size())
        fail(Status::not_found, "visits %zu and %zu of %zu", first, second,
             visits.expressions.size());
    std::vector<char> inside(static_cast<std::size_t>(n), 0);
    for (const std::uint32_t vertex : zone)
        if (vertex < static_cast<std::uint64_t>(n)) inside[vertex] = 1;
    // Area normals of the first neutral face in the training's frame; a vertex has a third of its
    // triangles'.
    const Points base =
        visits.poses[first].inverse().apply(PointsRef(visits.neutral_vertices[first]));
    const Points doubled = triangle_normals(base, model.triangles);
    Vector gradient = Vector::Zero(3 * n);  // mm^3 per mm
    for (Index t = 0; t < model.triangles.rows(); ++t)
        for (int corner = 0; corner < 3; ++corner) {
            const Index v = model.triangles(t, corner);
            if (inside[static_cast<std::size_t>(v)])
                gradient.segment<3>(3 * v) += doubled.row(t).transpose() / 6.0;
        }
    Vector along(model.num_identity_modes() + q);
    along << project_modes(context, model.identity_modes, gradient),
        project_modes(context, model.expression_modes, gradient);
    const Vector slope = 1e-3 * model.spill.pull_vector(along).tail(q);
    RemovedVolume result;
    result.removed_ml = slope.dot(visits.expressions[second] - visits.expressions[first]);
    const auto block = [&](std::size_t k, std::size_t l) {
        return visits.covariance.block(static_cast<Index>(k) * q, static_cast<Index>(l) * q, q, q);
    };
    const Matrix spread =
        block(first, first) + block(second, second) - block(first, second) - block(second, first);
    result.sd_ml = std::sqrt(std::max(0.0, slope.dot(spread * slope)));
    return result;
}

}  // namespace mien
