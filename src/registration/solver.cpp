#include "registration/solver.hpp"

#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"

namespace mien {
namespace {

using MatrixF = Eigen::MatrixXf;
using VectorF = Eigen::VectorXf;
constexpr int kGramLife = 4;  // steps for which one Phi' W Phi serves as preconditioner

// Flat unknown: kernel (3 r, axis by axis), pca (p), motion (7 or 6 or 0).
struct Layout {
    Index r, p, g;
    Index size() const { return 3 * r + p + g; }
};

Matrix3 unpack(const Eigen::Matrix<float, 1, 6>& h) {
    Matrix3 m;
    m << h[0], h[3], h[4], h[3], h[1], h[5], h[4], h[5], h[2];
    return m;
}

}  // namespace

// The coupled normal equations of one step: products with them and a preconditioner.
class FitSystem {
  public:
    FitSystem(FitSolver& solver, const FitTerms& terms, const PointsRef& current,
              const FitStepOptions& options, Layout layout, const Context& context)
        : solver_(solver),
          terms_(terms),
          current_(current),
          options_(options),
          layout_(layout),
          context_(context) {
        centre_ = current.colwise().mean().transpose();
        radius_ =
            std::sqrt((current.rowwise() - centre_.transpose()).rowwise().squaredNorm().mean());
        if (!(radius_ > 0)) radius_ = 1;
        field_.resize(current.rows(), 3);
        set_ridge();
        if (layout_.r > 0) factor_kernel();
        if (layout_.r == 0 && layout_.p + layout_.g > 0) factor_vectors();
    }

    double radius() const { return radius_; }
    const Vector3& centre() const { return centre_; }
    void load_pull() { field_ = terms_.pull; }

    // out = B' field.
    void project(VectorF& out) {
        out.resize(layout_.size());
        if (layout_.r > 0) {
            MatrixF product;
            dense::project_thin(context_, solver_.basis().leftCols(layout_.r), field_, product);
            out.head(3 * layout_.r) = Eigen::Map<const VectorF>(product.data(), 3 * layout_.r);
        }
        project_vectors(out);
    }

    // out = A theta.
    void apply(const VectorF& theta, VectorF& out) {
        const Index r = layout_.r, kernel = 3 * r, p = layout_.p;
        expand_vectors(theta);
        out.resize(layout_.size());
        if (r > 0) {
            MatrixF product;
            dense::expand_and_project(
                context_, solver_.basis().leftCols(r),
                Eigen::Map<const MatrixF>(theta.data(), r, 3), field_,
                [this](Index first, Index count) { weigh(first, count); }, product);
            out.head(kernel) = Eigen::Map<const VectorF>(product.data(), kernel);
        } else {
            weigh(0, field_.rows());
        }
        project_vectors(out);
        out.head(kernel).array() += kernel_ridge_.array() * theta.head(kernel).array();
        out.segment(kernel, p) += static_cast<float>(options_.pca_ridge) * theta.segment(kernel, p);
    }

    void precondition(const VectorF& in, VectorF& out) const {
        out = in;
        const Index r = layout_.r, q = layout_.p + layout_.g;
        if (r > 0)
            for (int axis = 0; axis < 3; ++axis)
                dense::solve_factored(kernel_factor_[factor_of_[axis]],
                                      Eigen::Map<MatrixF>(out.data() + axis * r, r, 1));
        if (q == 0) return;
        if (coupled()) out.tail(q).noalias() -= coupling_.transpose() * out.head(3 * r);
        dense::solve_factored(vector_factor_, Eigen::Map<MatrixF>(out.data() + 3 * r, q, 1));
        if (coupled()) out.head(3 * r).noalias() -= carried_ * out.tail(q);
    }

  private:
    // field = H field, in some of its rows.
    void weigh(Index first, Index count) {
        for (Index i = first; i < first + count; ++i) {
            const auto h = terms_.precision.row(i);
            const float x = field_(i, 0), y = field_(i, 1), z = field_(i, 2);
            field_(i, 0) = h[0] * x + h[3] * y + h[4] * z;
            field_(i, 1) = h[3] * x + h[1] * y + h[5] * z;
            field_(i, 2) = h[4] * x + h[5] * y + h[2] * z;
        }
    }

    // The trained modes' and the motion's part of out = B' field.
    void project_vectors(VectorF& out) {
        const Index r = layout_.r, p = layout_.p, m = field_.rows();
        if (p > 0) {
            flat_ = field_.cast<double>();  // x0 y0 z0 x1 ...
            const Eigen::Map<const Vector> flat(flat_.data(), 3 * m);
            out.segment(3 * r, p) =
                dense::project(context_, solver_.pca().leftCols(p), flat).cast<float>();
        }
        if (layout_.g > 0) {
            Eigen::Matrix<double, 7, 1> sum = Eigen::Matrix<double, 7, 1>::Zero();
            for (Index i = 0; i < m; ++i) {
                const Vector3 h = field_.row(i).transpose().cast<double>();
                const Vector3 y = (current_.row(i).transpose() - centre_) / radius_;
                sum.head<3>() += y.cross(h);
                sum.segment<3>(3) += h;
                sum[6] += y.dot(h);
            }
            out.tail(layout_.g) = sum.head(layout_.g).cast<float>();
        }
    }

    // The trained modes' and the motion's part of field = B theta.
    void expand_vectors(const VectorF& theta) {
        const Index r = layout_.r, p = layout_.p, m = field_.rows();
        if (p > 0) {
            flat_.setZero(m, 3);
            dense::add_product(context_, solver_.pca().leftCols(p),
                               theta.segment(3 * r, p).cast<double>(),
                               Eigen::Map<Vector>(flat_.data(), 3 * m));
            field_ = flat_.cast<float>();
        } else {
            field_.setZero();
        }
        if (layout_.g > 0) {
            Eigen::Matrix<double, 7, 1> g = Eigen::Matrix<double, 7, 1>::Zero();
            g.head(layout_.g) = theta.tail(layout_.g).cast<double>();
            const Vector3 w = g.head<3>(), t = g.segment<3>(3);
            for (Index i = 0; i < m; ++i) {
                const Vector3 y = (current_.row(i).transpose() - centre_) / radius_;
                field_.row(i) += (w.cross(y) + t + g[6] * y).cast<float>().transpose();
            }
        }
    }

    double total_weight() const { return terms_.precision.leftCols<3>().cast<double>().sum() / 3; }

    void factor_kernel() {
        const Index r = layout_.r, m = field_.rows();
        if (solver_.gram_.rows() != r ||
            (coupled() && solver_.coupling_.cols() != layout_.p + layout_.g) ||
            solver_.gram_age_ >= kGramLife || !(solver_.gram_weight_ > 0)) {
            // Every second or third row stands for all, because this is a preconditioner only; rows
            // that weigh much (landmarks) stand for themselves.
            const Index stride = m > 6000 ? 3 : (m > 2000 ? 2 : 1);
            const float heavy = static_cast<float>(3 * total_weight() / static_cast<double>(m));
            std::vector<Index> rows;
            std::vector<float> weights;
            for (Index i = 0; i < m; ++i) {
                const float weight = terms_.precision.row(i).head<3>().sum() / 3;
                if (weight <= heavy && i % stride != 0) continue;
                rows.push_back(i);
                weights.push_back(weight > heavy ? weight : static_cast<float>(stride) * weight);
            }
            const Index sampled = static_cast<Index>(rows.size());
            const auto basis = solver_.basis();
            const VectorF root = Eigen::Map<const VectorF>(weights.data(), sampled).cwiseSqrt();
            MatrixF sample(sampled, r);
            parallel_for(
                context_, static_cast<std::size_t>(r), 16, [&](std::size_t b, std::size_t e) {
                    for (Index j = static_cast<Index>(b); j < static_cast<Index>(e); ++j) {
                        const float* column = basis.data() + j * basis.outerStride();
                        for (Index k = 0; k < sampled; ++k)
                            sample(k, j) = root[k] * column[rows[static_cast<std::size_t>(k)]];
                    }
                });
            solver_.gram_.resize(r, r);
            dense::weighted_gram(context_, sample, VectorF(), solver_.gram_);
            solver_.gram_weight_ = root.cast<double>().squaredNorm();
            solver_.gram_age_ = 0;
            if (coupled()) couple_vectors(rows, root, sample);
        }
        ++solver_.gram_age_;
        const double scale = solver_.gram_weight_ > 0 ? total_weight() / solver_.gram_weight_ : 0;
        for (int axis = 0; axis < 3; ++axis) {
            factor_of_[axis] = axis;
            for (int before = axis - 1; before >= 0; --before)
                if (kernel_ridge_.segment(axis * r, r) == kernel_ridge_.segment(before * r, r))
                    factor_of_[axis] = before;
            if (factor_of_[axis] != axis) continue;
            MatrixF system = static_cast<float>(scale) * solver_.gram_;
            system.diagonal() += kernel_ridge_.segment(axis * r, r);
            if (!dense::factor_spd(system))
                fail(Status::no_solution,
                     "the normal equations of the fit are not positive definite");
            kernel_factor_[axis] = std::move(system);
        }
        if (coupled()) factor_coupled(scale);
    }

    // The kernel's smooth modes are nearly motions, and nearly the trained modes too. Seen apart, a
    // motion and the modes that undo it look stiff, and together only the prior resists them:
    // conjugate gradients wander along such pairs for tens of iterations, and in single precision
    // never twice along the same way. So all are preconditioned together,
    //
    //   [K C; C' M]^-1,  K = Phi' W Phi + ridge,  C = Phi' W V,  M = V' W V + ridge,
    //
    // V the trained modes and the motions, by the Schur complement S = M - C' K^-1 C.
    bool coupled() const { return layout_.r > 0 && layout_.p + layout_.g > 0; }

    // Trained modes and small motions of row i, one column each.
    void vectors_at(Index i, Eigen::Matrix<float, 3, Eigen::Dynamic>& block) const {
        if (layout_.p > 0) block.leftCols(layout_.p) = solver_.pca().block(3 * i, 0, 3, layout_.p);
        if (layout_.g > 0) {
            const Vector3 y = (current_.row(i).transpose() - centre_) / radius_;
            Eigen::Matrix<double, 3, 7> motion;
            motion << 0, y[2], -y[1], 1, 0, 0, y[0], -y[2], 0, y[0], 0, 1, 0, y[1], y[1], -y[0], 0,
                0, 0, 1, y[2];
            block.rightCols(layout_.g) = motion.leftCols(layout_.g).cast<float>();
        }
    }

    // `sample`: the kernel's modes at `rows`, times the roots of the weights.
    void couple_vectors(const std::vector<Index>& rows, const VectorF& root,
                        const MatrixF& sample) {
        const Index q = layout_.p + layout_.g, m = sample.rows(), r = sample.cols();
        MatrixF vectors(3 * m, q);  // axis by axis, times the roots
        parallel_for(context_, static_cast<std::size_t>(m), 512, [&](std::size_t b, std::size_t e) {
            Eigen::Matrix<float, 3, Eigen::Dynamic> block(3, q);
            for (std::size_t k = b; k < e; ++k) {
                vectors_at(rows[k], block);
                const Index i = static_cast<Index>(k);
                for (int axis = 0; axis < 3; ++axis)
                    vectors.row(axis * m + i) = root[i] * block.row(axis);
            }
        });
        solver_.vector_gram_.resize(q, q);
        dense::weighted_gram(context_, vectors, VectorF(), solver_.vector_gram_);
        solver_.coupling_.resize(3 * r, q);
        for (int axis = 0; axis < 3; ++axis)
            dense::multiply(context_, 1.0f, sample, dense::Op::transpose,
                            vectors.middleRows(axis * m, m), dense::Op::none, 0.0f,
                            solver_.coupling_.middleRows(axis * r, r));
    }

    void factor_coupled(double scale) {
        const Index r = layout_.r, p = layout_.p;
        coupling_ = static_cast<float>(scale) * solver_.coupling_;
        carried_ = coupling_;
        for (int axis = 0; axis < 3; ++axis)
            dense::solve_factored(kernel_factor_[factor_of_[axis]],
                                  carried_.middleRows(axis * r, r));
        MatrixF gram = static_cast<float>(scale) * solver_.vector_gram_;
        // Something where nothing is seen at all.
        gram.diagonal().array() += 1e-6f * std::max(1.0f, gram.diagonal().maxCoeff());
        gram.diagonal().head(p).array() += static_cast<float>(options_.pca_ridge);
        MatrixF difference = gram;
        dense::multiply(context_, -1.0f, coupling_, dense::Op::transpose, carried_, dense::Op::none,
                        1.0f, difference);
        // What single precision takes away from the difference is given back, with M itself as the
        // upper bound.
        for (float more = 1e-4f; more < 2; more *= 10) {
            vector_factor_ = difference;
            vector_factor_.diagonal() += more * gram.diagonal();
            if (dense::factor_spd(vector_factor_)) return;
        }
        fail(Status::no_solution, "the normal equations of the fit are not positive definite");
    }

    // rho over the prior variance of each mode and axis; models without a preference have ones.
    void set_ridge() {
        const Index r = layout_.r;
        kernel_ridge_.setConstant(3 * r, static_cast<float>(options_.kernel_ridge));
        const Matrix& variance = solver_.model_.prior_variance;
        if (variance.rows() < r || variance.cols() != 3) return;
        for (int axis = 0; axis < 3; ++axis)
            for (Index j = 0; j < r; ++j)
                kernel_ridge_[axis * r + j] =
                    static_cast<float>(options_.kernel_ridge / std::max(variance(j, axis), 1e-4));
    }

    void factor_vectors() {
        const Index q = layout_.p + layout_.g, m = field_.rows();
        MatrixF stacked(3 * m, q);
        parallel_for(context_, static_cast<std::size_t>(m), 512, [&](std::size_t b, std::size_t e) {
            Eigen::Matrix<float, 3, Eigen::Dynamic> block(3, q);
            for (std::size_t k = b; k < e; ++k) {
                const Index i = static_cast<Index>(k);
                vectors_at(i, block);
                // A square root of H (semidefinite): its eigenvectors, scaled.
                Eigen::SelfAdjointEigenSolver<Matrix3> eigen;
                eigen.computeDirect(unpack(terms_.precision.row(i)));
                const Matrix3 root = eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() *
                                     eigen.eigenvectors().transpose();
                stacked.middleRows(3 * i, 3).noalias() = root.cast<float>() * block;
            }
        });
        MatrixF gram(q, q);
        dense::weighted_gram(context_, stacked, VectorF(), gram);
        gram.diagonal().head(layout_.p).array() += static_cast<float>(options_.pca_ridge);
        // The motion has no prior; a whisper of one keeps a fit without any hit solvable.
        gram.diagonal().tail(layout_.g).array() +=
            1e-6f * std::max(1.0f, gram.diagonal().maxCoeff());
        if (!dense::factor_spd(gram))
            fail(Status::no_solution, "the normal equations of the fit are not positive definite");
        vector_factor_ = std::move(gram);
    }

    FitSolver& solver_;
    const FitTerms& terms_;
    const PointsRef current_;
    const FitStepOptions& options_;
    const Layout layout_;
    const Context& context_;
    Vector3 centre_;
    double radius_ = 1;
    dense::Field field_;
    Points flat_;
    VectorF kernel_ridge_;  // 3 r
    int factor_of_[3] = {0, 1, 2};
    MatrixF kernel_factor_[3], vector_factor_;  // Cholesky, lower triangles, of K and S
    MatrixF coupling_, carried_;                // C and K^-1 C, 3 r x (p + g)
};

void FitTerms::reset(Index num_rows) {
    precision.setZero(num_rows, 6);
    pull.setZero(num_rows, 3);
}

void FitTerms::add(Index row, const Matrix3& h, const Vector3& pulled) {
    const Eigen::Matrix<double, 1, 6> packed{h(0, 0), h(1, 1), h(2, 2), h(0, 1), h(0, 2), h(1, 2)};
    precision.row(row) += packed.cast<float>();
    pull.row(row) += pulled.cast<float>().transpose();
}

void FitTerms::add_isotropic(Index row, double weight, const Vector3& target_displacement) {
    precision.row(row).head<3>().array() += static_cast<float>(weight);
    pull.row(row) += (weight * target_displacement).cast<float>().transpose();
}

void FitTerms::add_planar(Index row, double weight, double tau, const Vector3& normal,
                          const Vector3& target_displacement) {
    const Matrix3 h =
        weight * ((1 - tau) * normal * normal.transpose() + tau * Matrix3::Identity());
    const Eigen::Matrix<double, 1, 6> packed{h(0, 0), h(1, 1), h(2, 2), h(0, 1), h(0, 2), h(1, 2)};
    precision.row(row) += packed.cast<float>();
    pull.row(row) += (h * target_displacement).cast<float>().transpose();
}

FitSolver::FitSolver(const DeformationModel& model)
    : model_(model), num_rows_(model.num_vertices()) {}

FitSolver::ConstMap FitSolver::basis() const {
    if (rows_.empty())
        return ConstMap(model_.basis.data, num_rows_, model_.basis.cols,
                        Eigen::OuterStride<>(num_rows_));
    return ConstMap(packed_basis_.data(), num_rows_, packed_basis_.cols(),
                    Eigen::OuterStride<>(num_rows_));
}

FitSolver::ConstMap FitSolver::pca() const {
    if (rows_.empty())
        return ConstMap(model_.pca_modes.data, 3 * num_rows_, model_.pca_modes.cols,
                        Eigen::OuterStride<>(3 * num_rows_));
    return ConstMap(packed_pca_.data(), 3 * num_rows_, packed_pca_.cols(),
                    Eigen::OuterStride<>(3 * num_rows_));
}

void FitSolver::use_rows(std::vector<Index> rows, Index scalar_modes, Index pca_modes,
                         const Context& context) {
    rows_ = std::move(rows);
    gram_.resize(0, 0);
    num_rows_ = rows_.empty() ? model_.num_vertices() : static_cast<Index>(rows_.size());
    if (rows_.empty()) {
        packed_basis_.resize(0, 0);
        packed_pca_.resize(0, 0);
        return;
    }
    context.require_memory(static_cast<std::size_t>(num_rows_ * (scalar_modes + 3 * pca_modes)) * 4,
                           "the fit");
    packed_basis_.resize(num_rows_, scalar_modes);
    packed_pca_.resize(3 * num_rows_, pca_modes);
    const Index n = model_.num_vertices();
    parallel_for(
        context, static_cast<std::size_t>(scalar_modes + pca_modes), 8,
        [&](std::size_t b, std::size_t e) {
            for (Index j = static_cast<Index>(b); j < static_cast<Index>(e); ++j)
                for (Index k = 0; k < num_rows_; ++k) {
                    const Index i = rows_[static_cast<std::size_t>(k)];
                    if (j < scalar_modes)
                        packed_basis_(k, j) = model_.basis.data[j * n + i];
                    else
                        for (int axis = 0; axis < 3; ++axis)
                            packed_pca_(3 * k + axis, j - scalar_modes) =
                                model_.pca_modes.data[(j - scalar_modes) * 3 * n + 3 * i + axis];
                }
        });
}

Similarity FitSolver::step(const FitTerms& terms, const PointsRef& current,
                           const FitStepOptions& options, FitCoefficients& coefficients,
                           const Context& context) {
    const Layout layout{std::min(options.scalar_modes, coefficients.kernel.rows()),
                        std::min(options.pca_modes, coefficients.pca.size()),
                        options.move ? (options.scale ? 7 : 6) : 0};
    const Index r = layout.r, p = layout.p;
    Similarity motion;
    if (layout.size() == 0) return motion;
    FitSystem system(*this, terms, current, options, layout, context);

    VectorF theta = VectorF::Zero(layout.size());
    for (int axis = 0; axis < 3; ++axis)
        theta.segment(axis * r, r) = coefficients.kernel.col(axis).head(r);
    theta.segment(3 * r, p) = coefficients.pca.head(p);

    VectorF rhs, residual, z, direction, image;
    system.load_pull();
    system.project(rhs);
    system.apply(theta, image);
    residual = rhs - image;
    system.precondition(rhs, z);
    const double whole = rhs.cast<double>().dot(z.cast<double>());
    system.precondition(residual, z);
    direction = z;
    double rz = residual.cast<double>().dot(z.cast<double>());
    // Relative to where this step began, but not below what single precision can tell apart.
    const double limit =
        std::max({options.tolerance * options.tolerance * rz, 1e-10 * whole, 1e-30});
    iterations_ = 0;
    while (iterations_ < options.max_iterations && rz > limit) {
        system.apply(direction, image);
        const double curvature = direction.cast<double>().dot(image.cast<double>());
        if (!(curvature > 0)) break;
        const float step_length = static_cast<float>(rz / curvature);
        theta += step_length * direction;
        residual -= step_length * image;
        system.precondition(residual, z);
        const double next = residual.cast<double>().dot(z.cast<double>());
        direction = z + static_cast<float>(next / rz) * direction;
        rz = next;
        ++iterations_;
    }
    if (!theta.allFinite())
        fail(Status::no_solution, "the fit's equations gave values that are not finite");

    for (int axis = 0; axis < 3; ++axis)
        coefficients.kernel.col(axis).head(r) = theta.segment(axis * r, r);
    coefficients.pca.head(p) = theta.segment(3 * r, p);
    if (layout.g > 0) {
        const Eigen::VectorXd g = theta.tail(layout.g).cast<double>();
        const Vector3 w = g.head<3>() / system.radius();
        motion.scale = layout.g == 7 ? std::exp(g[6] / system.radius()) : 1.0;
        if (w.norm() > 0)
            motion.rotation = Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix();
        motion.translation =
            system.centre() + g.segment<3>(3) - motion.scale * (motion.rotation * system.centre());
    }
    return motion;
}

Points FitSolver::displacement(const FitCoefficients& coefficients, const Context& context) const {
    const Index n = model_.num_vertices(), r = coefficients.kernel.rows(),
                p = coefficients.pca.size();
    Points u = model_.mean_displacement.rows() == n ? model_.mean_displacement : Points::Zero(n, 3);
    if (r > 0) {
        dense::Field moved = dense::Field::Zero(n, 3);
        dense::add_thin_product(context, model_.basis.map().leftCols(r), coefficients.kernel,
                                moved);
        u += moved.cast<double>();
    }
    if (p > 0) {
        dense::add_product(context, model_.pca_modes.map().leftCols(p),
                           coefficients.pca.cast<double>(), Eigen::Map<Vector>(u.data(), 3 * n));
    }
    return u;
}

}  // namespace mien
