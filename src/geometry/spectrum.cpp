// The first eigenpairs of L u = lambda M u by spectrum slicing (Parlett 1980, ch. 3; Grimes, Lewis
// & Simon 1994). M is diagonal, so the problem is A y = lambda y with A = M^-1/2 L M^-1/2, u =
// M^-1/2 y.
//
// 1. The null space (a constant on each connected component) is written down, never iterated for.
// 2. Shifts are placed by Weyl's law and moved until the inertias of the factorised A - s I, which
//    count the eigenvalues below s, are about 80 apart.
// 3. Each shift's nearest pairs are found on their own, in parallel. Neighbours overlap by a few
//    pairs: in the overlap both must have found the same eigenvalues.
// 4. Between two shifts as many pairs are taken as the inertias count; the upper end is proved by
//    one more factorisation in the gap behind the last pair. What cannot be proved is an error.
#include "geometry/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <memory>
#include <numeric>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/scalar_math.hpp"
#include "geometry/spectrum_slice.hpp"

namespace mien {
namespace {

constexpr Index kSliceWidth = 80;          // balances solves against orthogonalisation (measured)
constexpr Index kOverlap = 6;              // pairs that neighbouring slices both find
constexpr Index kDenseSize = 320;          // below this a dense solver is faster than one slice
constexpr std::size_t kSlicesAtATime = 8;  // between two reports of progress

struct Problem {
    SparseMatrix a;  // lower triangle and diagonal, in fill-reducing order
    KernelProjector kernel;
    std::vector<int> place;  // place[i]: row of vertex i
    Vector scale;            // M^-1/2 by vertex
    double area = 0;
};

struct Shift {
    std::shared_ptr<const ShiftedFactor> factor;
    double value = 0;
    Index count = 0;  // eigenvalues below
};

/// Factorises A - value I; a shift that hits an eigenvalue is moved a little.
Shift make_shift(const SparseMatrix& a, double value) {
    for (int attempt = 0; attempt < 5; ++attempt) {
        const double moved = value * (1.0 + 1.3e-6 * attempt * attempt);
        auto factor = std::make_shared<const ShiftedFactor>(a, moved);
        if (factor->ok()) return {factor, moved, factor->num_below()};
    }
    fail(Status::no_solution, "the Laplacian cannot be factorised at the shift %.9g", value);
}

Problem make_problem(const LaplaceOperator& laplace) {
    const Index n = laplace.stiffness.rows();
    Problem problem;
    problem.scale = laplace.mass.cwiseSqrt().cwiseInverse();
    problem.area = laplace.mass.sum();
    problem.place = fill_reducing_order(laplace.stiffness);

    std::vector<Index> root(static_cast<std::size_t>(n));
    std::iota(root.begin(), root.end(), Index(0));
    const auto find = [&](Index i) {
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
    };
    std::vector<Eigen::Triplet<double, int>> entries;
    entries.reserve(static_cast<std::size_t>(laplace.stiffness.nonZeros()) / 2 + n);
    for (Index j = 0; j < n; ++j)
        for (SparseMatrix::InnerIterator it(laplace.stiffness, j); it; ++it) {
            const Index i = it.row();
            if (i < j) continue;
            const int pi = problem.place[i], pj = problem.place[j];
            entries.emplace_back(std::max(pi, pj), std::min(pi, pj),
                                 it.value() * problem.scale[i] * problem.scale[j]);
            if (it.value() != 0 && i != j) {
                const Index a = find(i), b = find(j);
                if (a != b) root[std::max(a, b)] = std::min(a, b);
            }
        }
    // Every diagonal entry must exist for the shift.
    for (Index j = 0; j < n; ++j)
        entries.emplace_back(static_cast<int>(j), static_cast<int>(j), 0.0);
    problem.a.resize(n, n);
    problem.a.setFromTriplets(entries.begin(), entries.end());

    KernelProjector& kernel = problem.kernel;
    kernel.component.assign(static_cast<std::size_t>(n), -1);
    kernel.direction.resize(n);
    std::vector<std::int32_t> number(static_cast<std::size_t>(n), -1);
    std::vector<double> mass;
    for (Index i = 0; i < n; ++i) {
        std::int32_t& component = number[find(i)];
        if (component < 0) {
            component = static_cast<std::int32_t>(kernel.num_components++);
            mass.push_back(0.0);
        }
        kernel.component[problem.place[i]] = component;
        mass[component] += laplace.mass[i];
    }
    for (Index i = 0; i < n; ++i)
        kernel.direction[problem.place[i]] =
            std::sqrt(laplace.mass[i] / mass[kernel.component[problem.place[i]]]);
    return problem;
}

/// Shifts whose counts cut [kernel, last) into slices of about kSliceWidth.
std::vector<Shift> place_shifts(const Problem& problem, Index last, const Context& context) {
    const Index first = problem.kernel.num_components, n = problem.a.rows();
    const Index wanted = last - first;
    const Index num_slices = std::max<Index>(1, (wanted + kSliceWidth / 2) / kSliceWidth);
    const double width = static_cast<double>(wanted) / static_cast<double>(num_slices);

    // Weyl: N(lambda) ~ area lambda / (4 pi). The first probe corrects it for borders and for what
    // the triangulation does to the higher frequencies.
    std::vector<Shift> known;
    known.push_back(make_shift(problem.a, 4 * kPi * (0.5 * wanted + 1) / problem.area));
    std::vector<double> guesses;
    for (int round = 0; round < 12; ++round) {
        guesses.clear();
        // Between the kernel and the first shift, between shifts, and from the last one to the end.
        double low = 0, low_count = static_cast<double>(first);
        for (std::size_t i = 0; i <= known.size(); ++i) {
            const bool open = i == known.size();
            if (open && low_count >= last) break;
            const double high_count = open ? static_cast<double>(last) : known[i].count;
            double high = open ? 0 : known[i].value;
            if (open) {
                const double found = low_count - first;
                const double growth = found > 0 ? (last - first) / found : 4.0;
                high = low * std::min(4.0, growth);
            }
            // Half a slice at either end, a whole one between two shifts.
            const bool lowest = i == 0;
            const double end_pad = (lowest ? 0.5 * width : 0.0) + (open ? 0.5 * width : 0.0);
            const double gap = std::min(high_count, last + 0.5 * width) - low_count;
            const double limit =
                lowest || open ? (lowest && open ? width : 0.9 * width) : 1.6 * width;
            if (gap > limit && low_count < last) {
                const int inner =
                    std::max(1, static_cast<int>(std::lround((gap + end_pad) / width)) - 1);
                const double step = (gap + end_pad) / (inner + 1);
                for (int s = 1; s <= inner; ++s) {
                    const double target = low_count + s * step - (lowest ? 0.5 * width : 0.0);
                    double fraction = (target - low_count) / (high_count - low_count);
                    fraction = std::min(0.98, std::max(0.02, fraction));
                    guesses.push_back(low + fraction * (high - low));
                }
            }
            if (!open) {
                low = known[i].value;
                low_count = known[i].count;
            }
        }
        if (guesses.empty()) break;
        std::vector<Shift> fresh(guesses.size());
        parallel_for(context, guesses.size(), 1, [&](std::size_t begin, std::size_t) {
            fresh[begin] = make_shift(problem.a, guesses[begin]);
        });
        known.insert(known.end(), fresh.begin(), fresh.end());
        std::sort(known.begin(), known.end(),
                  [](const Shift& a, const Shift& b) { return a.value < b.value; });
    }
    // Leave out what no slice needs: shifts beyond the end, and shifts whose neighbours are near
    // enough to each other.
    std::vector<Shift> plan;
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (known[i].count > last + width / 4 && !plan.empty()) continue;
        if (!plan.empty() && known[i].count - plan.back().count < std::min(4 * kOverlap, n / 4) &&
            i + 1 < known.size())
            continue;
        const double before = plan.empty() ? first - 0.5 * width : plan.back().count;
        const bool has_next = i + 1 < known.size() && known[i + 1].count <= last + width / 4;
        const double after = has_next ? known[i + 1].count : last + 0.5 * width;
        if ((has_next || !plan.empty()) && after - before < 1.2 * width) continue;
        plan.push_back(known[i]);
    }
    if (plan.empty()) plan.push_back(known.front());
    return plan;
}

[[noreturn]] void fail_count(double value) {
    fail(Status::no_solution,
         "eigenpairs near %.9g do not match the count that the inertia of the Laplacian proves; "
         "the mesh may hold many equal pieces: take them apart",
         value);
}

/// Index in [low, high] with the widest gap between values[i - 1] and values[i].
Index widest_gap(const Vector& values, Index low, Index high) {
    Index best = low;
    double widest = -1;
    for (Index i = low; i <= high; ++i) {
        const double gap = values[i] - values[i - 1];
        if (gap > widest) {
            widest = gap;
            best = i;
        }
    }
    return best;
}

/// What a slice contributes: columns [begin, end) of its pairs.
struct Share {
    Index begin = 0, end = 0;
};

/// Makes the columns of `right` orthogonal to those of `left`, which they are but for rounding and
/// for clusters that a junction cuts.
void join(const Context& context, Eigen::Ref<Matrix> left, Eigen::Ref<Matrix> right, double value) {
    if (left.cols() == 0 || right.cols() == 0) return;
    Matrix cross(left.cols(), right.cols());
    dense::multiply(context, 1.0, left, dense::Op::transpose, right, dense::Op::none, 0.0, cross);
    if (cross.cwiseAbs().maxCoeff() < 1e-6) {
        // One Newton step towards the nearest orthonormal basis squares the defect.
        const Matrix half = 0.5 * cross, half_transposed = half.transpose();
        const Matrix old_left = left;
        dense::multiply(context, -1.0, right, dense::Op::none, half_transposed, dense::Op::none,
                        1.0, left);
        dense::multiply(context, -1.0, old_left, dense::Op::none, half, dense::Op::none, 1.0,
                        right);
        return;
    }
    for (Index c = 0; c < right.cols(); ++c) {
        if (cross.col(c).cwiseAbs().maxCoeff() < 1e-12) continue;
        for (int pass = 0; pass < 3; ++pass) {
            right.col(c) -= left * (left.transpose() * right.col(c));
            for (Index d = 0; d < right.cols(); ++d)
                if (d < c || (d > c && cross.col(d).cwiseAbs().maxCoeff() < 1e-12))
                    right.col(c) -= right.col(d).dot(right.col(c)) * right.col(d);
            const double length = right.col(c).norm();
            if (!(length > 1e-3)) fail_count(value);
            right.col(c) /= length;
        }
    }
}

/// Signs: the first entry (by vertex) within a hair of the largest magnitude is positive. The hair
/// keeps the choice stable on symmetric meshes, whose antisymmetric modes have two such entries.
void fix_sign(Eigen::Ref<Vector> u) {
    const double bound = 0.999 * u.cwiseAbs().maxCoeff();
    for (Index i = 0; i < u.size(); ++i)
        if (std::abs(u[i]) >= bound) {
            if (u[i] < 0) u = -u;
            return;
        }
}

EigenPairs dense_pairs(const LaplaceOperator& laplace, Index k) {
    const Vector scale = laplace.mass.cwiseSqrt().cwiseInverse();
    const Matrix a = scale.asDiagonal() * Matrix(laplace.stiffness) * scale.asDiagonal();
    Eigen::SelfAdjointEigenSolver<Matrix> solver(a);
    if (solver.info() != Eigen::Success)
        fail(Status::no_solution, "the dense eigenproblem of the Laplacian did not converge");
    EigenPairs pairs;
    pairs.values = solver.eigenvalues().head(k).cwiseMax(0.0);
    pairs.vectors = scale.asDiagonal() * solver.eigenvectors().leftCols(k);
    for (Index c = 0; c < k; ++c) fix_sign(pairs.vectors.col(c));
    return pairs;
}

/// Two slices look for the pairs between their shifts from either side and overlap: where the
/// overlap agrees, the widest gap is the safest place to pass from the left slice to the right one.
/// Returns the number of pairs, of `between`, that the left slice gives. Throws Status::no_solution
/// where both disagree.
Index cut_between(const Eigen::Ref<const Vector>& left_values,
                  const Eigen::Ref<const Vector>& right_values, Index between, double left_shift,
                  double right_shift) {
    const Index from_left = left_values.size(), right_offset = between - right_values.size();
    const double tolerance = 1e-6 * right_shift;
    Index cut = right_offset;
    double widest = -1;
    for (Index j = right_offset; j <= from_left; ++j) {
        if (j < from_left && j >= right_offset &&
            std::abs(left_values[j] - right_values[j - right_offset]) > tolerance)
            fail_count(left_values[j]);
        const double lower = j == 0           ? left_shift
                             : j <= from_left ? left_values[j - 1]
                                              : right_values[j - 1 - right_offset];
        const double upper = j == between        ? right_shift
                             : j >= right_offset ? right_values[j - right_offset]
                                                 : left_values[j];
        if (upper - lower > widest) {
            widest = upper - lower;
            cut = j;
        }
    }
    return cut;
}

/// Fills the columns of `pairs` behind the null space, in factor order, as vectors of A.
void sliced_pairs(const Problem& problem, Index k, EigenPairs& pairs, const Context& context,
                  const std::function<void(double)>& progress) {
    const Index n = problem.a.rows(), kernel = problem.kernel.num_components;
    std::vector<Shift> shifts = place_shifts(problem, k, context);
    const std::size_t num_slices = shifts.size();

    // How many pairs each slice looks for on either side.
    std::vector<Index> below(num_slices), above(num_slices);
    for (std::size_t i = 0; i < num_slices; ++i) {
        if (i == 0) below[i] = shifts[i].count - kernel;
        if (i + 1 < num_slices) {
            const Index between = shifts[i + 1].count - shifts[i].count;
            above[i] = std::min(between, between / 2 + kOverlap);
            below[i + 1] = std::min(between, between - between / 2 + kOverlap);
        } else {
            above[i] =
                std::min(n - shifts[i].count, std::max<Index>(0, k - shifts[i].count) + kOverlap);
        }
    }
    std::vector<SlicePairs> slices(num_slices);
    // A few at a time, so that the host sees progress.
    for (std::size_t first = 0; first < num_slices; first += kSlicesAtATime) {
        progress(0.15 + 0.7 * static_cast<double>(first) / static_cast<double>(num_slices));
        const std::size_t count = std::min(kSlicesAtATime, num_slices - first);
        parallel_for(context, count, 1, [&](std::size_t k_of_batch, std::size_t) {
            const std::size_t i = first + k_of_batch;
            slices[i] = slice_eigenpairs(*shifts[i].factor, problem.kernel, below[i], above[i],
                                         0x6d69656eull + i, context);
            shifts[i].factor.reset();
        });
    }
    progress(0.85);

    std::vector<Share> shares(num_slices);
    for (std::size_t i = 0; i < num_slices; ++i) shares[i].end = slices[i].values.size();
    for (std::size_t i = 0; i + 1 < num_slices; ++i) {
        const Index between = shifts[i + 1].count - shifts[i].count;
        const Index right_offset = between - below[i + 1];
        const Index cut =
            cut_between(slices[i].values.tail(above[i]), slices[i + 1].values.head(below[i + 1]),
                        between, shifts[i].value, shifts[i + 1].value);
        shares[i].end = below[i] + cut;
        shares[i + 1].begin = cut - right_offset;
    }

    // The upper end: pairs are proved complete by the count in the widest gap behind pair k.
    SlicePairs& top = slices.back();
    const Index base = shifts.back().count - below.back();  // number of the slice's first pair
    if (base + top.values.size() < n) {
        const Index size = top.values.size();
        const Index needed = std::max<Index>(1, k - base);
        const Index cut = widest_gap(top.values, std::min(needed, size - 1), size - 1);
        const double gap_middle = 0.5 * (top.values[cut - 1] + top.values[cut]);
        const Shift proof = make_shift(problem.a, gap_middle);
        if (proof.count != base + cut) fail_count(gap_middle);
    }

    for (std::size_t i = 0; i + 1 < num_slices; ++i) {
        const auto left = [&](std::size_t s) {
            return slices[s].vectors.middleCols(shares[s].begin, shares[s].end - shares[s].begin);
        };
        join(context, left(i), left(i + 1), shifts[i + 1].value);
    }
    Index column = kernel;
    for (std::size_t i = 0; i < num_slices; ++i) {
        const Index count = std::min(shares[i].end - shares[i].begin, k - column);
        if (count <= 0) break;
        pairs.vectors.middleCols(column, count) =
            slices[i].vectors.middleCols(shares[i].begin, count);
        slices[i].vectors.resize(0, 0);
        column += count;
    }
    if (column != k) fail_count(shifts.back().value);
}

void check_operator(const LaplaceOperator& laplace, Index k) {
    const Index n = laplace.stiffness.rows();
    if (laplace.stiffness.cols() != n || laplace.mass.size() != n)
        fail(Status::mismatch, "stiffness of %lld rows with %lld masses", static_cast<long long>(n),
             static_cast<long long>(laplace.mass.size()));
    if (k < 1 || k >= n)
        fail(Status::invalid_argument, "%lld eigenpairs of a mesh with %lld vertices",
             static_cast<long long>(k), static_cast<long long>(n));
    if (!(laplace.mass.minCoeff() > 0) || !laplace.mass.allFinite())
        fail(Status::invalid_argument, "the mass of every vertex must be positive and finite");
    for (Index j = 0; j < n; ++j)
        for (SparseMatrix::InnerIterator it(laplace.stiffness, j); it; ++it)
            if (!std::isfinite(it.value()))
                fail_at(Status::invalid_argument, j, "the stiffness of vertex %lld is not finite",
                        static_cast<long long>(j));
}

// Slices end in Ritz values; the refined ones may change places within a cluster.
void sort_pairs(EigenPairs& pairs) {
    const Index k = pairs.values.size();
    std::vector<Index> order(static_cast<std::size_t>(k));
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return pairs.values[a] < pairs.values[b]; });
    for (Index c = 0; c < k; ++c)
        if (order[c] != c) {
            // Follow the cycle, so that no second n x k matrix is needed.
            Vector held = pairs.vectors.col(c);
            const double held_value = pairs.values[c];
            Index at = c;
            while (order[at] != c) {
                const Index from = order[at];
                pairs.vectors.col(at) = pairs.vectors.col(from);
                pairs.values[at] = pairs.values[from];
                order[at] = at;
                at = from;
            }
            pairs.vectors.col(at) = held;
            pairs.values[at] = held_value;
            order[at] = at;
        }
}

}  // namespace

EigenPairs smallest_eigenpairs(const LaplaceOperator& laplace, Index k, const Context& context,
                               const std::function<void(double)>& progress) {
    const auto report = [&](double share) {
        context.check_cancelled();
        if (progress) progress(share);
    };
    const Index n = laplace.stiffness.rows();
    check_operator(laplace, k);
    report(0);
    if (n <= kDenseSize) {
        EigenPairs pairs = dense_pairs(laplace, k);
        report(1);
        return pairs;
    }

    context.require_memory(static_cast<std::size_t>(n) * static_cast<std::size_t>(k) * 3 * 8,
                           "the eigenvectors of the Laplacian");
    const Problem problem = make_problem(laplace);
    EigenPairs pairs;
    pairs.vectors.resize(n, k);
    const Index kernel = std::min(k, problem.kernel.num_components);
    pairs.vectors.leftCols(kernel).setZero();
    for (Index i = 0; i < n; ++i)
        if (problem.kernel.component[i] < kernel)
            pairs.vectors(i, problem.kernel.component[i]) = problem.kernel.direction[i];
    report(0.05);
    if (kernel < k) sliced_pairs(problem, k, pairs, context, report);

    // Rayleigh quotients square the error of the vectors; residuals are the last word.
    pairs.values = Vector::Zero(k);
    Vector residual = Vector::Zero(k);
    parallel_for(context, static_cast<std::size_t>(k), 8, [&](std::size_t begin, std::size_t end) {
        Vector y(n), image(n), u(n);
        for (auto c = static_cast<Index>(begin); c < static_cast<Index>(end); ++c) {
            y = pairs.vectors.col(c);
            y /= y.norm();
            image.noalias() = problem.a.selfadjointView<Eigen::Lower>() * y;
            const double value = y.dot(image);
            residual[c] = (image - value * y).norm();
            pairs.values[c] = c < kernel ? 0.0 : std::max(0.0, value);
            for (Index i = 0; i < n; ++i) u[i] = problem.scale[i] * y[problem.place[i]];
            fix_sign(u);
            pairs.vectors.col(c) = u;
        }
    });
    // Rounding alone leaves about eps |A|; a mesh with needles has a huge |A|.
    double largest = 0;
    for (Index j = 0; j < n; ++j) largest = std::max(largest, std::abs(problem.a.coeff(j, j)));
    const double allowed = 1e-6 * pairs.values[k - 1] + 1e-11 * largest;
    for (Index c = kernel; c < k; ++c)
        if (!(residual[c] <= allowed))
            fail(Status::no_solution, "eigenpair %lld near %.9g has a residual of %.3g",
                 static_cast<long long>(c), pairs.values[c], residual[c]);
    sort_pairs(pairs);
    report(1);
    return pairs;
}

}  // namespace mien
