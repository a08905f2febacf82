#include "registration/fit_system.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace mien {
namespace {

constexpr const char* kNotDefinite = "the normal equations of the fit are not positive definite";

Matrix3 unpack(const Eigen::Matrix<float, 1, 6>& h) {
    Matrix3 m;
    m << h[0], h[3], h[4], h[3], h[1], h[5], h[4], h[5], h[2];
    return m;
}

}  // namespace

FitSystem::FitSystem(FitSolver::ConstMap basis, FitSolver::ConstMap pca,
                     const Matrix& prior_variance, GramCache& cache, const FitTerms& terms,
                     const PointsRef& current, const FitStepOptions& options, FitLayout layout,
                     const Context& context)
    : basis_(basis),
      pca_(pca),
      cache_(cache),
      terms_(terms),
      current_(current),
      options_(options),
      layout_(layout),
      context_(context) {
    centre_ = current.colwise().mean().transpose();
    radius_ = std::sqrt((current.rowwise() - centre_.transpose()).rowwise().squaredNorm().mean());
    if (!(radius_ > 0)) radius_ = 1;
    field_.resize(current.rows(), 3);
    set_ridge(prior_variance);
    if (layout_.r > 0) factor_kernel();
    if (layout_.r == 0 && layout_.p + layout_.g > 0) factor_vectors();
}

void FitSystem::project(VectorF& out) {
    out.resize(layout_.size());
    if (layout_.r > 0) {
        MatrixF product;
        dense::project_thin(context_, basis_.leftCols(layout_.r), field_, product);
        out.head(3 * layout_.r) = Eigen::Map<const VectorF>(product.data(), 3 * layout_.r);
    }
    project_vectors(out);
}

void FitSystem::add_expected(VectorF& out) const {
    if (options_.kernel_mean == nullptr) return;
    const Index r = layout_.r;
    for (int axis = 0; axis < 3; ++axis)
        out.segment(axis * r, r).array() += kernel_ridge_.segment(axis * r, r).array() *
                                            options_.kernel_mean->col(axis).head(r).array();
}

void FitSystem::apply(const VectorF& theta, VectorF& out) {
    const Index r = layout_.r, kernel = 3 * r, p = layout_.p;
    expand_vectors(theta);
    out.resize(layout_.size());
    if (r > 0) {
        MatrixF product;
        dense::expand_and_project(
            context_, basis_.leftCols(r), Eigen::Map<const MatrixF>(theta.data(), r, 3), field_,
            [this](Index first, Index count) { weigh(first, count); }, product);
        out.head(kernel) = Eigen::Map<const VectorF>(product.data(), kernel);
    } else {
        weigh(0, field_.rows());
    }
    project_vectors(out);
    out.head(kernel).array() += kernel_ridge_.array() * theta.head(kernel).array();
    out.segment(kernel, p) += static_cast<float>(options_.pca_ridge) * theta.segment(kernel, p);
}

void FitSystem::precondition(const VectorF& in, VectorF& out) const {
    out = in;
    const Index r = layout_.r, q = layout_.p + layout_.g;
    if (r > 0)
        parallel_for(context_, 3, 1, [&](std::size_t axis, std::size_t) {
            dense::solve_factored(
                kernel_factor_[factor_of_[axis]],
                Eigen::Map<MatrixF>(out.data() + static_cast<Index>(axis) * r, r, 1));
        });
    if (q == 0) return;
    if (coupled()) out.tail(q).noalias() -= coupling_.transpose() * out.head(3 * r);
    dense::solve_factored(vector_factor_, Eigen::Map<MatrixF>(out.data() + 3 * r, q, 1));
    if (coupled()) out.head(3 * r).noalias() -= carried_ * out.tail(q);
}

// field = H field, in some of its rows.
void FitSystem::weigh(Index first, Index count) {
    for (Index i = first; i < first + count; ++i) {
        const auto h = terms_.precision.row(i);
        const float x = field_(i, 0), y = field_(i, 1), z = field_(i, 2);
        field_(i, 0) = h[0] * x + h[3] * y + h[4] * z;
        field_(i, 1) = h[3] * x + h[1] * y + h[5] * z;
        field_(i, 2) = h[4] * x + h[5] * y + h[2] * z;
    }
}

// The trained modes' and the motion's part of out = B' field.
void FitSystem::project_vectors(VectorF& out) {
    const Index r = layout_.r, p = layout_.p, m = field_.rows();
    if (p > 0) {
        flat_ = field_.cast<double>();  // x0 y0 z0 x1 ...
        const Eigen::Map<const Vector> flat(flat_.data(), 3 * m);
        out.segment(3 * r, p) = dense::project(context_, pca_.leftCols(p), flat).cast<float>();
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
void FitSystem::expand_vectors(const VectorF& theta) {
    const Index r = layout_.r, p = layout_.p, m = field_.rows();
    if (p > 0) {
        flat_.setZero(m, 3);
        dense::add_product(context_, pca_.leftCols(p), theta.segment(3 * r, p).cast<double>(),
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

// Trained modes and small motions of row i, one column each.
void FitSystem::vectors_at(Index i, Eigen::Matrix<float, 3, Eigen::Dynamic>& block) const {
    if (layout_.p > 0) block.leftCols(layout_.p) = pca_.block(3 * i, 0, 3, layout_.p);
    if (layout_.g > 0) {
        const Vector3 y = (current_.row(i).transpose() - centre_) / radius_;
        Eigen::Matrix<double, 3, 7> motion;
        motion << 0, y[2], -y[1], 1, 0, 0, y[0], -y[2], 0, y[0], 0, 1, 0, y[1], y[1], -y[0], 0, 0,
            0, 1, y[2];
        block.rightCols(layout_.g) = motion.leftCols(layout_.g).cast<float>();
    }
}

// rho over the prior variance of each mode and axis; models without a preference have ones.
void FitSystem::set_ridge(const Matrix& variance) {
    const Index r = layout_.r;
    kernel_ridge_.setConstant(3 * r, static_cast<float>(options_.kernel_ridge));
    if (variance.rows() < r || variance.cols() != 3) return;
    for (int axis = 0; axis < 3; ++axis)
        for (Index j = 0; j < r; ++j)
            kernel_ridge_[axis * r + j] =
                static_cast<float>(options_.kernel_ridge /
                                   std::max(variance(j, axis), options_.solver.least_variance));
}

void FitSystem::factor_kernel() {
    const Index r = layout_.r;
    if (cache_.gram.rows() != r || (coupled() && cache_.coupling.cols() != layout_.p + layout_.g) ||
        cache_.age >= options_.solver.gram_life || !(cache_.weight > 0))
        sample_gram();
    ++cache_.age;
    const double scale = cache_.weight > 0 ? total_weight() / cache_.weight : 0;
    std::vector<int> axes;  // with a ridge of their own
    for (int axis = 0; axis < 3; ++axis) {
        factor_of_[axis] = axis;
        for (int before = axis - 1; before >= 0; --before)
            if (kernel_ridge_.segment(axis * r, r) == kernel_ridge_.segment(before * r, r))
                factor_of_[axis] = before;
        if (factor_of_[axis] == axis) axes.push_back(axis);
    }
    bool definite[3] = {true, true, true};
    parallel_for(context_, axes.size(), 1, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) {
            const int axis = axes[k];
            MatrixF system = static_cast<float>(scale) * cache_.gram;
            system.diagonal() += kernel_ridge_.segment(axis * r, r);
            definite[axis] = dense::factor_spd(system);
            kernel_factor_[axis] = std::move(system);
        }
    });
    if (!(definite[0] && definite[1] && definite[2])) fail(Status::no_solution, kNotDefinite);
    if (coupled()) factor_coupled(scale);
}

// Phi' W Phi from a sample: every second or third row stands for all, because this is a
// preconditioner only; rows that weigh much (landmarks) stand for themselves.
void FitSystem::sample_gram() {
    const SolverSettings& settings = options_.solver;
    const Index r = layout_.r, m = field_.rows();
    const Index stride =
        m > settings.sample_third_from ? 3 : (m > settings.sample_half_from ? 2 : 1);
    const float heavy =
        static_cast<float>(settings.heavy * total_weight() / static_cast<double>(m));
    std::vector<Index> rows;
    std::vector<float> weights;
    for (Index i = 0; i < m; ++i) {
        const float weight = terms_.precision.row(i).head<3>().sum() / 3;
        if (weight <= heavy && i % stride != 0) continue;
        rows.push_back(i);
        weights.push_back(weight > heavy ? weight : static_cast<float>(stride) * weight);
    }
    const Index sampled = static_cast<Index>(rows.size());
    const VectorF root = Eigen::Map<const VectorF>(weights.data(), sampled).cwiseSqrt();
    MatrixF sample(sampled, r);
    parallel_for(context_, static_cast<std::size_t>(r), 16, [&](std::size_t b, std::size_t e) {
        for (Index j = static_cast<Index>(b); j < static_cast<Index>(e); ++j) {
            const float* column = basis_.data() + j * basis_.outerStride();
            for (Index k = 0; k < sampled; ++k)
                sample(k, j) = root[k] * column[rows[static_cast<std::size_t>(k)]];
        }
    });
    cache_.gram.resize(r, r);
    dense::weighted_gram(context_, sample, VectorF(), cache_.gram);
    cache_.weight = root.cast<double>().squaredNorm();
    cache_.age = 0;
    if (coupled()) couple_vectors(rows, root, sample);
}

// `sample`: the kernel's modes at `rows`, times the roots of the weights.
void FitSystem::couple_vectors(const std::vector<Index>& rows, const VectorF& root,
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
    cache_.vector_gram.resize(q, q);
    dense::weighted_gram(context_, vectors, VectorF(), cache_.vector_gram);
    cache_.coupling.resize(3 * r, q);
    for (int axis = 0; axis < 3; ++axis)
        dense::multiply(context_, 1.0f, sample, dense::Op::transpose,
                        vectors.middleRows(axis * m, m), dense::Op::none, 0.0f,
                        cache_.coupling.middleRows(axis * r, r));
}

void FitSystem::factor_coupled(double scale) {
    const Index r = layout_.r, p = layout_.p;
    coupling_ = static_cast<float>(scale) * cache_.coupling;
    carried_ = coupling_;
    parallel_for(context_, 3, 1, [&](std::size_t axis, std::size_t) {
        dense::solve_factored(kernel_factor_[factor_of_[axis]],
                              carried_.middleRows(static_cast<Index>(axis) * r, r));
    });
    MatrixF gram = static_cast<float>(scale) * cache_.vector_gram;
    // Something where nothing is seen at all.
    gram.diagonal().array() += options_.solver.ground * std::max(1.0f, gram.diagonal().maxCoeff());
    gram.diagonal().head(p).array() += static_cast<float>(options_.pca_ridge);
    MatrixF difference = gram;
    dense::multiply(context_, -1.0f, coupling_, dense::Op::transpose, carried_, dense::Op::none,
                    1.0f, difference);
    // What single precision takes away from the difference is given back, with M itself as the
    // upper bound.
    for (float more = options_.solver.mend_from; more < options_.solver.mend_to; more *= 10) {
        vector_factor_ = difference;
        vector_factor_.diagonal() += more * gram.diagonal();
        if (dense::factor_spd(vector_factor_)) return;
    }
    fail(Status::no_solution, kNotDefinite);
}

// Without kernel modes the system is small, and its Cholesky factor an exact preconditioner.
void FitSystem::factor_vectors() {
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
            if (eigen.info() != Eigen::Success || !eigen.eigenvalues().allFinite())
                fail(Status::no_solution, kNotDefinite);
            const Matrix3 root = eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() *
                                 eigen.eigenvectors().transpose();
            stacked.middleRows(3 * i, 3).noalias() = root.cast<float>() * block;
        }
    });
    MatrixF gram(q, q);
    dense::weighted_gram(context_, stacked, VectorF(), gram);
    gram.diagonal().head(layout_.p).array() += static_cast<float>(options_.pca_ridge);
    // The motion has no prior; a tiny one keeps a fit without any hit solvable.
    gram.diagonal().tail(layout_.g).array() +=
        options_.solver.ground * std::max(1.0f, gram.diagonal().maxCoeff());
    if (!dense::factor_spd(gram)) fail(Status::no_solution, kNotDefinite);
    vector_factor_ = std::move(gram);
}

}  // namespace mien
