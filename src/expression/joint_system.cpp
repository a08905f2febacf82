#include "expression/joint_system.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "geometry/normals.hpp"

namespace mien {
namespace {

/// Keeps the normal equations of a pose definite where all normals are parallel; of their trace.
constexpr double kPoseRidge = 1e-9;

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

}  // namespace

JointSystem::JointSystem(const Context& context, const ExpressionModel& model,
                         const JointFitOptions& options, const std::vector<Vector>& weights,
                         Index stride)
    : context_(context),
      model_(model),
      options_(options),
      weights_(weights),
      count_(static_cast<Index>(weights.size())),
      p_(model.num_identity_modes()),
      q_(model.num_expression_modes()) {
    if (uniform()) return;
    for (Index v = 0; v < model.num_vertices(); v += stride) speakers_.push_back(v);
    modes_ = mode_rows(model, speakers_);
}

bool JointSystem::mixture() const {
    return options_.fit.method == FitMethod::mixture && !model_.components.empty();
}

double JointSystem::shared_noise() const {
    if (options_.fit.noise_mm2 > 0.0) return options_.fit.noise_mm2;
    return mixture() ? model_.mixture_noise_mm2 : model_.map_noise_mm2;
}

const FitPlan::Part& JointSystem::part(std::size_t component) const {
    return mixture() ? model_.plan->components[component] : model_.plan->map;
}

/// The coupling is the same at every vertex, so that the model's own small matrices say all.
bool JointSystem::uniform() const {
    return options_.noise == JointNoise::isotropic &&
           std::all_of(weights_.begin(), weights_.end(),
                       [](const Vector& weights) { return weights.size() == 0; });
}

void JointSystem::gather(const std::vector<Points>& placed) {
    const Index size = p_ + count_ * q_;
    data_ = Matrix::Zero(size, size);
    right_ = Vector::Zero(size);
    data_.topLeftCorner(p_, p_) = model_.identity_precision();
    if (uniform())
        gather_uniform(placed);
    else
        gather_blocks(placed);
    data_.bottomLeftCorner(count_ * q_, p_) = data_.topRightCorner(p_, count_ * q_).transpose();
}

void JointSystem::gather_uniform(const std::vector<Points>& placed) {
    const Matrix gram = model_.spill.pull_gram(model_.gram);
    const double noise = shared_noise(), own = 1.0 / (options_.face_noise_share * noise);
    const double shared = own * own / (1.0 / noise + static_cast<double>(count_) * own);
    std::vector<Vector> pulled;  // E' (v_l - mean)
    for (const Points& face : placed) {
        context_.check_cancelled();
        const Points apart = face - model_.mean;
        const Eigen::Map<const Vector> flat(apart.data(), apart.size());
        Vector along(p_ + q_);
        along << project_modes(context_, model_.identity_modes, flat),
            project_modes(context_, model_.expression_modes, flat);
        pulled.push_back(model_.spill.pull_vector(along));
    }
    for (Index k = 0; k < count_; ++k)
        for (Index l = 0; l < count_; ++l) {
            const double block = (k == l ? own : 0.0) - shared;
            const Vector evidence = block * pulled[static_cast<std::size_t>(l)];
            right_.head(p_) += evidence.head(p_);
            right_.segment(p_ + k * q_, q_) += evidence.tail(q_);
            add_gram(k, l, block * gram);
        }
}

/// M_k and what is needed of the common face d.
void JointSystem::weigh(const std::vector<Points>& placed) {
    const Index m = static_cast<Index>(speakers_.size());
    const bool isotropic = options_.noise == JointNoise::isotropic;
    const double noise = shared_noise(), own_noise = options_.face_noise_share * noise;
    precision_.assign(static_cast<std::size_t>(count_ * m), Matrix3::Zero());
    common_.assign(static_cast<std::size_t>(m), Matrix3::Identity() / noise);
    for (Index k = 0; k < count_; ++k) {
        const Vector& weights = weights_[static_cast<std::size_t>(k)];
        const Points normals =
            isotropic ? Points()
                      : vertex_normals(placed[static_cast<std::size_t>(k)], model_.triangles);
        for (Index i = 0; i < m; ++i) {
            const Index v = speakers_[static_cast<std::size_t>(i)];
            const double weight = weights.size() != 0 ? weights[v] : 1.0;
            Matrix3& own = precision_[static_cast<std::size_t>(k * m + i)];
            if (isotropic) {
                own = weight / own_noise * Matrix3::Identity();
            } else {
                const Vector3 normal = normals.row(v);
                const double across = weight / options_.tangential_noise_mm2,
                             along = weight / options_.normal_noise_mm2;
                own = across * Matrix3::Identity() + (along - across) * normal * normal.transpose();
            }
            common_[static_cast<std::size_t>(i)] += own;
        }
    }
    for (Matrix3& block : common_) block = block.inverse().eval();
}

void JointSystem::gather_blocks(const std::vector<Points>& placed) {
    weigh(placed);
    const Index m = static_cast<Index>(speakers_.size());
    Matrix coupled(modes_.rows(), modes_.cols());
    Vector pulled(modes_.rows());
    for (Index k = 0; k < count_; ++k)
        for (Index l = 0; l < count_; ++l) {
            context_.check_cancelled();
            const Points& face = placed[static_cast<std::size_t>(l)];
            for (Index i = 0; i < m; ++i) {
                const Matrix3 block = coupling(k, l, i);
                const Index v = speakers_[static_cast<std::size_t>(i)];
                if (block.isZero(0.0))  // a vertex without data may hold what is not finite
                    pulled.segment<3>(3 * i).setZero();
                else
                    pulled.segment<3>(3 * i) =
                        block * (face.row(v) - model_.mean.row(v)).transpose();
                if (l >= k)
                    coupled.middleRows(3 * i, 3).noalias() = block * modes_.middleRows(3 * i, 3);
            }
            const Vector along = modes_.transpose() * pulled;
            right_.head(p_) += along.head(p_);
            right_.segment(p_ + k * q_, q_) += along.tail(q_);
            if (l < k) continue;
            const Matrix gram = modes_.transpose() * coupled;
            add_gram(k, l, gram);
            if (l != k) add_gram(l, k, gram.transpose());
        }
}

Matrix3 JointSystem::coupling(Index k, Index l, Index i) const {
    const Index m = static_cast<Index>(speakers_.size());
    const Matrix3& left = precision_[static_cast<std::size_t>(k * m + i)];
    const Matrix3& right = precision_[static_cast<std::size_t>(l * m + i)];
    Matrix3 block = -left * common_[static_cast<std::size_t>(i)] * right;
    if (k == l) block += left;
    return block;
}

void JointSystem::add_gram(Index k, Index l, const Matrix& gram) {
    data_.topLeftCorner(p_, p_) += gram.topLeftCorner(p_, p_);
    data_.block(0, p_ + l * q_, p_, q_) += gram.topRightCorner(p_, q_);
    data_.block(p_ + k * q_, p_ + l * q_, q_, q_) += gram.bottomRightCorner(q_, q_);
}

Matrix JointSystem::with_priors(const std::vector<std::size_t>& choice) const {
    Matrix matrix = data_;
    for (Index k = 0; k < count_; ++k) {
        const Matrix& prior = part(choice[static_cast<std::size_t>(k)]).prior_precision;
        const Index own = p_ + k * q_;
        matrix.topLeftCorner(p_, p_) += prior.topLeftCorner(p_, p_);
        matrix.block(0, own, p_, q_) += prior.topRightCorner(p_, q_);
        matrix.block(own, 0, q_, p_) += prior.bottomLeftCorner(q_, p_);
        matrix.block(own, own, q_, q_) += prior.bottomRightCorner(q_, q_);
    }
    return matrix;
}

JointSystem::Solution JointSystem::solve_with(const std::vector<std::size_t>& choice) const {
    Vector right = right_;
    double offset = 0.0;
    for (Index k = 0; k < count_; ++k) {
        const std::size_t component = choice[static_cast<std::size_t>(k)];
        const FitPlan::Part& prior = part(component);
        const Vector pull = prior.prior_precision.rightCols(q_) * prior.mean.tail(q_);
        right.head(p_) += pull.head(p_);
        right.segment(p_ + k * q_, q_) += pull.tail(q_);
        offset += 0.5 * prior.log_det_prior - 0.5 * prior.mean.tail(q_).dot(pull.tail(q_));
        offset += std::log(prior.weight);
    }
    const Eigen::LLT<Matrix> factor(with_priors(choice));
    if (factor.info() != Eigen::Success)
        fail(Status::no_solution,
             "the joint fit of the faces is singular: too little of them is visible");
    Solution solution;
    solution.coordinates = factor.solve(right);
    solution.log_evidence = offset + 0.5 * solution.coordinates.dot(right) -
                            factor.matrixLLT().diagonal().array().log().sum();
    return solution;
}

void JointSystem::choose(std::vector<std::size_t>& chosen,
                         const std::vector<std::vector<std::size_t>>& candidates) {
    solution_ = solve_with(chosen);
    bool improved = mixture();
    for (int round = 0; improved && round < options_.search.max_rounds; ++round) {
        improved = false;
        for (std::size_t k = 0; k < chosen.size(); ++k)
            for (const std::size_t candidate : candidates[k]) {
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

Matrix JointSystem::covariance(const std::vector<std::size_t>& chosen) const {
    const Eigen::LLT<Matrix> factor(with_priors(chosen));
    if (factor.info() != Eigen::Success)
        fail(Status::no_solution, "the joint fit of the faces has no posterior: it is singular");
    return factor.solve(Matrix::Identity(data_.rows(), data_.cols()))
        .bottomRightCorner(count_ * q_, count_ * q_);
}

/// Every face less identity and expression, at the speakers.
std::vector<Vector> JointSystem::rests(const std::vector<Points>& placed) const {
    const Vector identity = modes_.leftCols(p_) * solution_.coordinates.head(p_);
    std::vector<Vector> rests;
    for (Index l = 0; l < count_; ++l) {
        Vector own = -identity - modes_.rightCols(q_) * expression(l);
        for (std::size_t i = 0; i < speakers_.size(); ++i)
            own.segment<3>(3 * static_cast<Index>(i)) +=
                (placed[static_cast<std::size_t>(l)].row(speakers_[i]) -
                 model_.mean.row(speakers_[i]))
                    .transpose();
        rests.push_back(std::move(own));
    }
    return rests;
}

void JointSystem::settle(Index k, std::vector<Points>& placed, Similarity& pose) const {
    using Pose6 = Eigen::Matrix<double, 6, 1>;
    const Index m = static_cast<Index>(speakers_.size());
    Points& face = placed[static_cast<std::size_t>(k)];
    const Points normals = vertex_normals(face, model_.triangles);
    const std::vector<Vector> rest = rests(placed);
    const Vector3 centre = model_.mean.colwise().mean();
    Eigen::Matrix<double, 6, 6> system = Eigen::Matrix<double, 6, 6>::Zero();
    Pose6 pull = Pose6::Zero();
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
        const double ratio = off / options_.search.far_mm;
        if (!(std::fabs(ratio) < 1)) continue;
        const double weight =
            weights_[static_cast<std::size_t>(k)][v] * (1 - ratio * ratio) * (1 - ratio * ratio);
        Pose6 row;
        row << (Vector3(face.row(v)) - centre).cross(normal), normal;
        system += weight * row * row.transpose();
        pull += weight * off * row;
        total += weight;
    }
    if (!(total > 0)) return;
    system.diagonal().array() += kPoseRidge * system.trace();
    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factor(system);
    if (factor.info() != Eigen::Success)
        fail(Status::no_solution, "the pose of face %lld is not determined by what is visible",
             static_cast<long long>(k));
    const Pose6 step = -factor.solve(pull);
    const double angle = step.head<3>().norm();
    Similarity motion;
    if (angle > 0)
        motion.rotation =
            Eigen::AngleAxisd(angle, Vector3(step.head<3>()) / angle).toRotationMatrix();
    motion.translation = centre - motion.rotation * centre + step.tail<3>();
    face = motion.apply(PointsRef(face));
    const Matrix3 rotation = pose.rotation * motion.rotation.transpose();  // pose o motion^-1
    pose.translation -= pose.scale * (rotation * motion.translation);
    pose.rotation = rotation;
}

}  // namespace mien
