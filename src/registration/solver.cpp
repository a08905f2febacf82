#include "registration/solver.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"

namespace mien {
namespace {

using MatrixF = Eigen::MatrixXf;
using VectorF = Eigen::VectorXf;
using MotionColumns = Eigen::Matrix<float, Eigen::Dynamic, 7>;
constexpr std::size_t kChunk = 1024;
constexpr Index kSampleStride = 3;  // every third vertex stands for all in the preconditioner

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

// d(place)/d(motion) of one place: rotation about the centre, shift, growth; lengths in units of
// `radius`, so that all seven columns weigh alike.
Eigen::Matrix<float, 3, 7> motion_block(const Vector3& place, const Vector3& centre, double radius) {
    const Vector3 y = (place - centre) / radius;
    Eigen::Matrix<float, 3, 7> block;
    block.setZero();
    block.block<3, 3>(0, 3).setIdentity();
    block(0, 1) = static_cast<float>(y[2]), block(0, 2) = static_cast<float>(-y[1]);
    block(1, 0) = static_cast<float>(-y[2]), block(1, 2) = static_cast<float>(y[0]);
    block(2, 0) = static_cast<float>(y[1]), block(2, 1) = static_cast<float>(-y[0]);
    block.col(6) = y.cast<float>();
    return block;
}

class System {
  public:
    System(const DeformationModel& model, const FitTerms& terms, const PointsRef& current,
           const FitStepOptions& options, Layout layout, const Context& context)
        : model_(model), terms_(terms), current_(current), options_(options), layout_(layout),
          context_(context) {
        centre_ = current.colwise().mean().transpose();
        radius_ = std::sqrt((current.rowwise() - centre_.transpose()).rowwise().squaredNorm().mean());
        if (!(radius_ > 0)) radius_ = 1;
        field_.resize(3, model.num_vertices());
        build_preconditioner();
    }

    double radius() const { return radius_; }
    const Vector3& centre() const { return centre_; }

    // B' h for h given as `field_` (3 x V).
    void project(VectorF& out) {
        const Index r = layout_.r, p = layout_.p, n = model_.num_vertices();
        out.resize(layout_.size());
        if (r > 0) {
            MatrixF by_axis = field_.transpose();
            MatrixF product(r, 3);
            dense::multiply(context_, 1.0f, model_.basis.map().leftCols(r), dense::Op::transpose,
                            by_axis, dense::Op::none, 0.0f, product);
            out.head(3 * r) = Eigen::Map<const VectorF>(product.data(), 3 * r);
        }
        if (p > 0) {
            const Eigen::Map<const VectorF> flat(field_.data(), 3 * n);
            parallel_for(context_, static_cast<std::size_t>(p), 16, [&](std::size_t b, std::size_t e) {
                const Index first = static_cast<Index>(b), count = static_cast<Index>(e - b);
                out.segment(3 * r + first, count).noalias() =
                    model_.pca_modes.map().middleCols(first, count).transpose() * flat;
            });
        }
        if (layout_.g > 0) {
            Eigen::Matrix<double, 7, 1> sum = Eigen::Matrix<double, 7, 1>::Zero();
            for (Index i = 0; i < n; ++i) {
                const Vector3 h = field_.col(i).cast<double>();
                if (h.isZero(0)) continue;
                const Vector3 y = (current_.row(i).transpose() - centre_) / radius_;
                sum.head<3>() += y.cross(h);
                sum.segment<3>(3) += h;
                sum[6] += y.dot(h);
            }
            out.tail(layout_.g) = sum.head(layout_.g).cast<float>();
        }
    }

    // field_ = B theta.
    void expand(const VectorF& theta) {
        const Index r = layout_.r, p = layout_.p, n = model_.num_vertices();
        if (r > 0) {
            const Eigen::Map<const MatrixF> a(theta.data(), r, 3);
            MatrixF moved(n, 3);
            dense::multiply(context_, 1.0f, model_.basis.map().leftCols(r), dense::Op::none, a,
                            dense::Op::none, 0.0f, moved);
            field_ = moved.transpose();
        } else {
            field_.setZero();
        }
        Eigen::Map<VectorF> flat(field_.data(), 3 * n);
        if (p > 0)
            parallel_for(context_, static_cast<std::size_t>(3 * n), 3 * kChunk,
                         [&](std::size_t b, std::size_t e) {
                             const Index first = static_cast<Index>(b);
                             const Index count = static_cast<Index>(e - b);
                             flat.segment(first, count).noalias() +=
                                 model_.pca_modes.map().leftCols(p).middleRows(first, count) *
                                 theta.segment(3 * r, p);
                         });
        if (layout_.g > 0) {
            Eigen::Matrix<double, 7, 1> g = Eigen::Matrix<double, 7, 1>::Zero();
            g.head(layout_.g) = theta.tail(layout_.g).cast<double>();
            const Vector3 w = g.head<3>(), t = g.segment<3>(3);
            for (Index i = 0; i < n; ++i) {
                const Vector3 y = (current_.row(i).transpose() - centre_) / radius_;
                field_.col(i) += (w.cross(y) + t + g[6] * y).cast<float>();
            }
        }
    }

    // field_ = H field_.
    void weigh() {
        for (Index i = 0; i < field_.cols(); ++i) {
            const auto h = terms_.precision.row(i);
            const Eigen::Vector3f u = field_.col(i);
            field_(0, i) = h[0] * u[0] + h[3] * u[1] + h[4] * u[2];
            field_(1, i) = h[3] * u[0] + h[1] * u[1] + h[5] * u[2];
            field_(2, i) = h[4] * u[0] + h[5] * u[1] + h[2] * u[2];
        }
    }

    void load_pull() { field_ = terms_.pull.transpose(); }

    void ridge(const VectorF& theta, VectorF& out) const {
        out.head(3 * layout_.r) += static_cast<float>(options_.kernel_ridge) * theta.head(3 * layout_.r);
        out.segment(3 * layout_.r, layout_.p) +=
            static_cast<float>(options_.pca_ridge) * theta.segment(3 * layout_.r, layout_.p);
    }

    void apply(const VectorF& theta, VectorF& out) {
        expand(theta);
        weigh();
        project(out);
        ridge(theta, out);
    }

    void precondition(const VectorF& in, VectorF& out) const {
        out.resize(in.size());
        if (layout_.r > 0) {
            Eigen::Map<MatrixF> block(out.data(), layout_.r, 3);
            block = Eigen::Map<const MatrixF>(in.data(), layout_.r, 3);
            kernel_factor_.solveInPlace(block);
        }
        if (layout_.p + layout_.g > 0) {
            out.tail(layout_.p + layout_.g) = in.tail(layout_.p + layout_.g);
            vector_factor_.solveInPlace(out.tail(layout_.p + layout_.g));
        }
    }

  private:
    void build_preconditioner() {
        const Index n = model_.num_vertices();
        std::vector<Index> rows;
        for (Index i = 0; i < n; i += layout_.p > 0 && layout_.r == 0 ? 1 : kSampleStride)
            if (terms_.precision.row(i).head<3>().maxCoeff() > 0) rows.push_back(i);
        double whole = 0, sampled = 0;
        for (Index i = 0; i < n; ++i) whole += terms_.precision.row(i).head<3>().sum();
        for (Index i : rows) sampled += terms_.precision.row(i).head<3>().sum();
        const double factor = sampled > 0 ? whole / sampled : 1;
        const Index m = static_cast<Index>(rows.size());
        if (layout_.r > 0) {
            const Index r = layout_.r;
            MatrixF sample(m, r);
            VectorF weight(m);
            for (Index k = 0; k < m; ++k) {
                const Index i = rows[static_cast<std::size_t>(k)];
                weight[k] = static_cast<float>(factor / 3) * terms_.precision.row(i).head<3>().sum();
            }
            const auto basis = model_.basis.map();
            parallel_for(context_, static_cast<std::size_t>(r), 16, [&](std::size_t b, std::size_t e) {
                for (Index j = static_cast<Index>(b); j < static_cast<Index>(e); ++j)
                    for (Index k = 0; k < m; ++k) sample(k, j) = basis(rows[static_cast<std::size_t>(k)], j);
            });
            MatrixF gram(r, r);
            dense::weighted_gram(context_, sample, weight, gram);
            gram.diagonal().array() += static_cast<float>(options_.kernel_ridge);
            kernel_factor_.compute(gram);
            if (kernel_factor_.info() != Eigen::Success)
                fail(Status::no_solution, "the normal equations of the fit are not positive definite");
        }
        const Index q = layout_.p + layout_.g;
        if (q > 0) {
            MatrixF stacked(3 * m, q);
            const auto modes = model_.pca_modes.map();
            parallel_for(context_, static_cast<std::size_t>(m), 512, [&](std::size_t b, std::size_t e) {
                Eigen::Matrix<float, 3, Eigen::Dynamic> block(3, q);
                for (std::size_t k = b; k < e; ++k) {
                    const Index i = rows[k];
                    block.leftCols(layout_.p) = modes.block(3 * i, 0, 3, layout_.p);
                    if (layout_.g > 0)
                        block.rightCols(layout_.g) =
                            motion_block(current_.row(i).transpose(), centre_, radius_).leftCols(layout_.g);
                    // A square root of H (semidefinite): its eigenvectors scaled.
                    Eigen::SelfAdjointEigenSolver<Matrix3> eigen;
                    eigen.computeDirect(factor * unpack(terms_.precision.row(i)));
                    const Matrix3 root = eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() *
                                         eigen.eigenvectors().transpose();
                    stacked.middleRows(3 * static_cast<Index>(k), 3).noalias() = root.cast<float>() * block;
                }
            });
            MatrixF gram(q, q);
            dense::weighted_gram(context_, stacked, VectorF(), gram);
            gram.diagonal().head(layout_.p).array() += static_cast<float>(options_.pca_ridge);
            // The motion has no prior; a whisper of one keeps a fit without any hit solvable.
            const float whisper = 1e-6f * std::max(1.0f, gram.diagonal().maxCoeff());
            gram.diagonal().tail(layout_.g).array() += whisper;
            vector_factor_.compute(gram);
            if (vector_factor_.info() != Eigen::Success)
                fail(Status::no_solution, "the normal equations of the fit are not positive definite");
        }
    }

    const DeformationModel& model_;
    const FitTerms& terms_;
    const PointsRef current_;
    const FitStepOptions& options_;
    const Layout layout_;
    const Context& context_;
    Vector3 centre_;
    double radius_ = 1;
    Eigen::Matrix<float, 3, Eigen::Dynamic> field_;
    Eigen::LLT<MatrixF> kernel_factor_, vector_factor_;
};

}  // namespace

void FitTerms::reset(Index num_vertices) {
    precision.setZero(num_vertices, 6);
    pull.setZero(num_vertices, 3);
}

void FitTerms::add_isotropic(Index vertex, double weight, const Vector3& target_displacement) {
    precision.row(vertex).head<3>().array() += static_cast<float>(weight);
    pull.row(vertex) += (weight * target_displacement).cast<float>().transpose();
}

void FitTerms::add_planar(Index vertex, double weight, double tau, const Vector3& normal,
                          const Vector3& target_displacement) {
    const Matrix3 h =
        weight * ((1 - tau) * normal * normal.transpose() + tau * Matrix3::Identity());
    precision.row(vertex) += Eigen::Matrix<double, 1, 6>(
        (Eigen::Matrix<double, 1, 6>() << h(0, 0), h(1, 1), h(2, 2), h(0, 1), h(0, 2), h(1, 2)).finished()).cast<float>();
    pull.row(vertex) += (h * target_displacement).cast<float>().transpose();
}

FitSolver::FitSolver(const DeformationModel& model) : model_(model) {}

Similarity FitSolver::step(const FitTerms& terms, const PointsRef& current,
                           const FitStepOptions& options, FitCoefficients& coefficients,
                           const Context& context) {
    const Layout layout{std::min(options.scalar_modes, model_.basis.cols),
                        std::min(options.pca_modes, model_.pca_modes.cols),
                        options.move ? (options.scale ? 7 : 6) : 0};
    System system(model_, terms, current, options, layout, context);
    const Index r = layout.r, p = layout.p;

    VectorF theta = VectorF::Zero(layout.size());
    for (int axis = 0; axis < 3; ++axis)
        theta.segment(axis * r, r) = coefficients.kernel.col(axis).head(r);
    theta.segment(3 * r, p) = coefficients.pca.head(p);

    VectorF rhs, residual, z, direction, image;
    system.load_pull();
    system.project(rhs);
    system.apply(theta, image);
    residual = rhs - image;
    system.precondition(residual, z);
    direction = z;
    double rz = residual.cast<double>().dot(z.cast<double>());
    VectorF rhs_z;
    system.precondition(rhs, rhs_z);
    const double limit = options.tolerance * options.tolerance *
                         std::max(rhs.cast<double>().dot(rhs_z.cast<double>()), 1e-30);
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

    Similarity motion;
    if (layout.g > 0) {
        const Eigen::VectorXd g = theta.tail(layout.g).cast<double>();
        const Vector3 w = g.head<3>() / system.radius();
        motion.scale = layout.g == 7 ? std::exp(g[6] / system.radius()) : 1.0;
        if (w.norm() > 0)
            motion.rotation = Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix();
        motion.translation = system.centre() + g.segment<3>(3) -
                             motion.scale * (motion.rotation * system.centre());
    }
    return motion;
}

Points FitSolver::displacement(const FitCoefficients& coefficients, const Context& context) const {
    const Index n = model_.num_vertices(), r = coefficients.kernel.rows(),
                p = coefficients.pca.size();
    Points u = model_.mean_displacement.rows() == n ? model_.mean_displacement : Points::Zero(n, 3);
    parallel_for(context, static_cast<std::size_t>(n), kChunk, [&](std::size_t b, std::size_t e) {
        const Index first = static_cast<Index>(b), count = static_cast<Index>(e - b);
        if (r > 0)
            u.middleRows(first, count) += (model_.basis.map().block(first, 0, count, r) *
                                           coefficients.kernel).cast<double>();
        if (p > 0) {
            const VectorF moved =
                model_.pca_modes.map().block(3 * first, 0, 3 * count, p) * coefficients.pca;
            u.middleRows(first, count) +=
                Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>>(
                    moved.data(), count, 3).cast<double>();
        }
    });
    return u;
}

}  // namespace mien
