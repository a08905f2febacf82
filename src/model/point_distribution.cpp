#include "model/point_distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <numeric>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/symmetric_eigen.hpp"
#include "geometry/alignment.hpp"
#include "geometry/laplacian.hpp"

namespace mien {
namespace {

/// Coordinates of all faces that are held at once, as a slice of rows.
constexpr Index kSliceRows = 3 * 2048;

void check(const PcaOptions& options) {
    if (options.num_modes < 0)
        fail(Status::invalid_argument, "a negative number of principal modes");
    if (options.num_modes == 0 && !(options.variance > 0 && options.variance <= 1))
        fail(Status::invalid_argument, "variance share %g is outside 0 .. 1", options.variance);
    if (!(options.extension_mm > 0) || !std::isfinite(options.extension_mm))
        fail(Status::invalid_argument, "extension length %g mm must be positive",
             options.extension_mm);
}

void check_correspondence(const FaceDataset& faces, const TriMesh& mesh) {
    if (faces.num_vertices() > mesh.vertices.rows())
        fail(Status::mismatch, "the dataset's faces have %lld vertices, the template %lld",
             static_cast<long long>(faces.num_vertices()),
             static_cast<long long>(mesh.vertices.rows()));
    const auto sorted = [](const Triangles& triangles) {
        std::vector<std::array<std::uint32_t, 3>> keys(static_cast<std::size_t>(triangles.rows()));
        for (std::size_t t = 0; t < keys.size(); ++t) {
            for (int k = 0; k < 3; ++k)
                keys[t][static_cast<std::size_t>(k)] = triangles(static_cast<Index>(t), k);
            std::sort(keys[t].begin(), keys[t].end());
        }
        std::sort(keys.begin(), keys.end());
        return keys;
    };
    const auto wanted = sorted(faces.triangles()), known = sorted(mesh.triangles);
    if (!std::includes(known.begin(), known.end(), wanted.begin(), wanted.end()))
        fail(Status::mismatch,
             "the dataset's triangles are not the template's; register the faces with this "
             "template");
}

/// Rigid motions of the chosen faces onto the template, or identities.
std::vector<Similarity> motions(const FaceDataset& faces, const std::vector<Index>& chosen,
                                const TriMesh& mesh, bool align, const Context& context) {
    std::vector<Similarity> result(chosen.size());
    if (!align) return result;
    const Points target = mesh.vertices.topRows(faces.num_vertices());
    Points face;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        context.check_cancelled();
        faces.face(chosen[k], face);
        result[k] = align_points(face, target, Vector(), false);
    }
    return result;
}

/// The chosen faces less the template, in the template's frame. They stay in the dataset's file and
/// are read once per pass.
class Displacements {
  public:
    Displacements(const FaceDataset& faces, const TriMesh& mesh, std::vector<Index> chosen,
                  bool align, const Context& context)
        : faces_(faces),
          mesh_(mesh),
          chosen_(std::move(chosen)),
          align_(align),
          motion_(motions(faces, chosen_, mesh, align, context)) {}

    Index count() const { return static_cast<Index>(chosen_.size()); }
    int subject(Index k) const { return faces_.subject(chosen_[static_cast<std::size_t>(k)]); }
    Index rows() const { return 3 * faces_.num_vertices(); }

    /// Computes the mean that slice() takes off, 3#V.
    const Vector& find_mean(const Context& context) {
        mean_.setZero(rows());
        const double s = static_cast<double>(count());
        Points face;
        for (Index k = 0; k < count(); ++k) {
            context.progress(Stage::training, 0.2 * static_cast<double>(k) / s);
            read(k, face);
            for (Index v = 0; v < faces_.num_vertices(); ++v)
                for (int c = 0; c < 3; ++c)
                    mean_[3 * v + c] += (face(v, c) - mesh_.vertices(v, c)) / s;
        }
        if (!mean_.allFinite())
            fail(Status::corrupt, "the dataset holds coordinates that are not finite");
        return mean_;
    }
    /// Coordinates [first, first + number) of all faces, a column each, less the mean.
    Matrix slice(Index first, Index number) const {
        Matrix values(number, count());
        Points face;
        for (Index k = 0; k < count(); ++k) {
            read(k, face);
            for (Index i = 0; i < number; ++i) {
                const Index v = (first + i) / 3, c = (first + i) % 3;
                values(i, k) = face(v, c) - mesh_.vertices(v, c) - mean_[first + i];
            }
        }
        return values;
    }

  private:
    void read(Index k, Points& face) const {
        faces_.face(chosen_[static_cast<std::size_t>(k)], face);
        if (align_) face = motion_[static_cast<std::size_t>(k)].apply(face);
    }

    const FaceDataset& faces_;
    const TriMesh& mesh_;
    std::vector<Index> chosen_;
    bool align_;
    std::vector<Similarity> motion_;
    Vector mean_;
};

/// Principal directions of the faces in the space of the faces (Turk and Pentland's small Gram
/// matrix): variances descending, and the coefficients that give unit modes' scaled columns.
struct GramModes {
    Vector variances;     ///< the kept ones
    Matrix coefficients;  ///< faces x kept
    double kept_share = 0;
    double left_out_mm = 0;  ///< as in PointDistribution
};

/// How many of the variances, descending, are kept of `count` faces; their sum goes to `kept`.
Index num_kept(const Vector& variances, Index count, const PcaOptions& options, double& kept) {
    const double total = variances.sum();
    const Index most = options.num_modes > 0 ? std::min(options.num_modes, count - 1) : count - 1;
    Index p = 0;
    kept = 0;
    while (p < most && variances[p] > 1e-12 * variances[0] &&
           (options.num_modes > 0 || kept < options.variance * total))
        kept += variances[p++];
    return p;
}

/// Sum over the faces `out` of the squares that the principal modes of the faces `in` leave of
/// them. `products`: of all faces' displacements about any one mean, faces x faces.
double squares_left(const Matrix& products, const std::vector<Index>& in,
                    const std::vector<Index>& out, const PcaOptions& options,
                    const Context& context) {
    Matrix inner = products(in, in), cross = products(out, in);
    const Vector mean = inner.rowwise().mean(), cross_mean = cross.rowwise().mean();
    const double level = mean.mean();
    inner.colwise() -= mean;
    inner.rowwise() -= mean.transpose();
    inner.array() += level;
    cross.colwise() -= cross_mean;
    cross.rowwise() -= mean.transpose();
    cross.array() += level;
    double left = 0;
    for (std::size_t k = 0; k < out.size(); ++k)
        left += products(out[k], out[k]) - 2 * cross_mean[static_cast<Index>(k)] + level;
    const SymmetricSpectrum spectrum(inner, "the principal modes of the faces", context);
    const Vector variances = spectrum.values().reverse().cwiseMax(0.0);
    double kept = 0;
    const Index p = num_kept(variances, static_cast<Index>(in.size()), options, kept);
    const Matrix vectors = spectrum.strongest(p, context);  // ascending
    for (Index j = 0; j < p; ++j)
        left -= (cross * vectors.col(p - 1 - j)).squaredNorm() / variances[j];
    return std::max(0.0, left);
}

/// As PointDistribution::left_out_mm.
double left_out_mm(const Displacements& displacements, const Matrix& products,
                   const PcaOptions& options, const Context& context) {
    constexpr std::size_t kFewest = 3, kFolds = 5;
    constexpr Index kManyFaces = 1500;  // of more, one fold tells enough
    std::vector<int> people;
    for (Index k = 0; k < displacements.count(); ++k) people.push_back(displacements.subject(k));
    std::sort(people.begin(), people.end());
    people.erase(std::unique(people.begin(), people.end()), people.end());
    if (people.size() < kFewest) return 0;
    const std::size_t folds = std::min(kFolds, people.size());
    double squares = 0, count = 0;
    for (std::size_t fold = 0; fold < folds; ++fold) {
        context.check_cancelled();
        std::vector<Index> in, out;
        for (Index k = 0; k < displacements.count(); ++k) {
            const auto person =
                std::lower_bound(people.begin(), people.end(), displacements.subject(k));
            const bool left_out = static_cast<std::size_t>(person - people.begin()) % folds == fold;
            (left_out ? out : in).push_back(k);
        }
        if (in.size() < 2) continue;
        squares += squares_left(products, in, out, options, context);
        count += static_cast<double>(out.size()) * static_cast<double>(displacements.rows());
        if (displacements.count() > kManyFaces) break;
    }
    return count > 0 ? std::sqrt(squares / count) : 0;
}

GramModes solve_gram(const Displacements& displacements, const PcaOptions& options,
                     const Context& context) {
    const Index s = displacements.count(), rows = displacements.rows();
    Matrix gram = Matrix::Zero(s, s), part(s, s);
    for (Index first = 0; first < rows; first += kSliceRows) {
        context.progress(Stage::training,
                         0.2 + 0.4 * static_cast<double>(first) / static_cast<double>(rows));
        dense::weighted_gram(context,
                             displacements.slice(first, std::min(kSliceRows, rows - first)),
                             Vector(), part);
        gram += part;
    }
    GramModes modes;
    modes.left_out_mm = left_out_mm(displacements, gram, options, context);
    gram /= static_cast<double>(s - 1);
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(gram);
    if (solver.info() != Eigen::Success || !solver.eigenvalues().allFinite())
        fail(Status::no_solution, "the principal modes of the faces did not converge");
    const Vector variances = solver.eigenvalues().reverse().cwiseMax(0.0);
    const double total = variances.sum();
    if (!(total > 0)) fail(Status::invalid_argument, "all faces of the dataset are the same");
    double kept = 0;
    const Index p = num_kept(variances, s, options, kept);
    modes.variances = variances.head(p);
    modes.coefficients = solver.eigenvectors().rowwise().reverse().leftCols(p) /
                         std::sqrt(static_cast<double>(s - 1));
    modes.kept_share = kept / total;
    return modes;
}

/// Per vertex x, y, z of the mean, then of every mode, so that one solve extends all. A mode's
/// greatest entry is positive.
Matrix mean_and_modes(const Displacements& displacements, const Vector& mean,
                      const Matrix& coefficients, const Context& context) {
    const Index rows = displacements.rows(), nd = rows / 3, p = coefficients.cols();
    Matrix known(nd, 3 * (p + 1));
    for (Index v = 0; v < nd; ++v)
        for (int c = 0; c < 3; ++c) known(v, c) = mean[3 * v + c];
    for (Index first = 0; first < rows; first += kSliceRows) {
        context.progress(Stage::training,
                         0.6 + 0.4 * static_cast<double>(first) / static_cast<double>(rows));
        const Index count = std::min(kSliceRows, rows - first);
        const Matrix modes = displacements.slice(first, count) * coefficients;
        for (Index i = 0; i < count; ++i)
            for (Index j = 0; j < p; ++j)
                known((first + i) / 3, 3 * (j + 1) + (first + i) % 3) = modes(i, j);
    }
    for (Index j = 0; j < p; ++j) {
        auto mode = known.middleCols(3 * (j + 1), 3);
        Index row = 0, column = 0;
        mode.cwiseAbs().maxCoeff(&row, &column);
        if (mode(row, column) < 0) mode = -mode;
    }
    return known;
}

}  // namespace

Matrix extend_smoothly(const TriMesh& mesh, const Matrix& known, double length_mm,
                       const Context& context) {
    const Index n = mesh.vertices.rows(), have = known.rows();
    Matrix all = Matrix::Zero(n, known.cols());
    all.topRows(have) = known;
    if (have == n) return all;
    const LaplaceOperator laplace =
        build_laplacian(mesh.vertices, mesh.triangles, LaplacianOptions{});
    context.check_cancelled();
    const Index missing = n - have;
    const SparseMatrix scaled = laplace.mass.cwiseInverse().asDiagonal() * laplace.stiffness;
    SparseMatrix energy = laplace.stiffness.transpose() * scaled;
    energy += laplace.stiffness / (length_mm * length_mm);
    SparseMatrix inner = energy.block(have, have, missing, missing);
    // Holds pieces that touch no known vertex at zero; far too little to be seen elsewhere.
    const double hold = 1e-9 * inner.diagonal().mean();
    for (Index v = 0; v < missing; ++v) inner.coeffRef(v, v) += hold;
    const SparseMatrix coupling = energy.block(have, 0, missing, have);
    Eigen::SimplicialLDLT<SparseMatrix> solver(inner);
    if (solver.info() != Eigen::Success)
        fail(Status::no_solution,
             "the modes cannot be continued over the template's other vertices");
    const Matrix right = -(coupling * known);
    all.bottomRows(missing) = solver.solve(right);
    if (solver.info() != Eigen::Success || !all.allFinite())
        fail(Status::no_solution,
             "the modes cannot be continued over the template's other vertices");
    return all;
}

PointDistribution train_point_distribution(const FaceDataset& faces, const TriMesh& template_mesh,
                                           const PcaOptions& options, const Context& context) {
    check(options);
    check_mesh(template_mesh, "the template");
    check_correspondence(faces, template_mesh);
    std::vector<Index> chosen;
    for (Index k = 0; k < faces.num_faces(); ++k)
        if (options.all_expressions || faces.expression(k) == faces.neutral_expression())
            chosen.push_back(k);
    const Index s = static_cast<Index>(chosen.size());
    if (s < 2)
        fail(Status::invalid_argument,
             "principal modes need at least two %sfaces, the dataset has %lld",
             options.all_expressions ? "" : "neutral ", static_cast<long long>(s));
    const Index nd = faces.num_vertices();
    context.require_memory(
        static_cast<std::size_t>(s) * static_cast<std::size_t>(3 * s + kSliceRows) * 8,
        "principal modes of the faces");
    Displacements displacements(faces, template_mesh, std::move(chosen), options.align, context);
    const Vector& mean = displacements.find_mean(context);
    const GramModes principal = solve_gram(displacements, options, context);
    PointDistribution result;
    result.num_faces = s;
    result.num_vertices = nd;
    result.variances = principal.variances;
    result.variance_explained = principal.kept_share;
    result.left_out_mm = principal.left_out_mm;
    const Matrix known = mean_and_modes(displacements, mean, principal.coefficients, context);
    const Matrix all = extend_smoothly(template_mesh, known, options.extension_mm, context);
    const Index n = template_mesh.vertices.rows(), p = principal.variances.size();
    result.mean = all.leftCols(3);
    result.modes.resize(3 * n, p);
    for (Index j = 0; j < p; ++j)
        for (Index v = 0; v < n; ++v)
            for (int c = 0; c < 3; ++c)
                result.modes(3 * v + c, j) = static_cast<float>(all(v, 3 * (j + 1) + c));
    context.progress(Stage::training, 1);
    return result;
}

}  // namespace mien
