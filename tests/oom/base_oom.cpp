// Eigen's containers outlive a failed allocation (cmake/MienEigen.cmake): a dense resize leaves an
// empty matrix and nothing is freed twice, a sparse constructor leaks nothing, and both can be used
// again afterwards. So do the decompositions; what is not swept here, the style check keeps out of
// the library.
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>
#include <Eigen/SVD>
#include <new>
#include <vector>

#include "base/types.hpp"
#include "fail_nth.hpp"

namespace {

using namespace mien;
using Sparse = Eigen::SparseMatrix<double>;
using RowSparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// True when the call ends, whether or not memory ran out.
template <typename Call>
bool ends(Call&& call) {
    try {
        call();
    } catch (const std::bad_alloc&) {
    }
    return true;
}

/// The matrix stays whole: all of its elements can be written after a resize that failed.
template <typename MatrixType>
bool resize_and_reuse(MatrixType& matrix, Index rows, Index cols) {
    bool failed = false;
    try {
        matrix.resize(rows, cols);
    } catch (const std::bad_alloc&) {
        failed = true;
    }
    matrix.setConstant(1);
    return failed ? matrix.size() == 0 && matrix.data() == nullptr : matrix.size() == rows * cols;
}

int sweep_dense() {
    int failed = 0;
    oom::Sweep resizes("dense resize");
    resizes.run([] {
        bool right = true;
        return ends([&] {
                   Matrix free(8, 8);
                   Vector vector(8);
                   Points wide(8, 3);
                   Eigen::Matrix<double, 3, Eigen::Dynamic> tall(3, 8);
                   right = right && resize_and_reuse(free, 16, 16);
                   right = right && resize_and_reuse(vector, 99, 1);
                   right = right && resize_and_reuse(wide, 99, 3);
                   right = right && resize_and_reuse(tall, 3, 99);
                   // The old size again: a matrix that remembered it would write through a null
                   // pointer.
                   right = right && resize_and_reuse(free, 8, 8);
                   right = right && resize_and_reuse(wide, 8, 3);
               }) &&
               right;
    });
    failed += resizes.report();

    oom::Sweep assignments("dense assignment");
    assignments.run([] {
        return ends([] {
            Matrix a = Matrix::Ones(8, 8), b = Matrix::Ones(8, 20);
            a = a * b;
            a = b.transpose();
            a.conservativeResize(30, 8);
            Matrix c = a;
            c = Matrix::Zero(2, 2);
            std::swap(a, c);
        });
    });
    failed += assignments.report();
    return failed;
}

int sweep_decompositions() {
    const Matrix random = Matrix::Random(70, 70);
    const Matrix positive = random * random.transpose() + Matrix::Identity(70, 70);
    oom::Sweep sweep("dense decompositions");
    sweep.run([&] {
        return ends([&] { const Eigen::SelfAdjointEigenSolver<Matrix> solver(positive); }) &&
               ends([&] { const Matrix x = positive.llt().solve(random); }) &&
               ends([&] { const Matrix x = positive.ldlt().solve(random); }) &&
               ends([&] { const Matrix x = random.partialPivLu().solve(positive); }) &&
               ends([&] { const Matrix q = random.householderQr().householderQ(); }) &&
               ends([&] { const Matrix x = random.colPivHouseholderQr().solve(positive); }) &&
               ends([&] {
                   const Eigen::JacobiSVD<Matrix> svd(random.leftCols(9), Eigen::ComputeThinU);
               });
    });
    return sweep.report();
}

int sweep_sparse() {
    int failed = 0;
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < 40; ++i) {
        entries.emplace_back(i, i, 4.0);
        entries.emplace_back(i, (i + 1) % 40, 1.0);
        entries.emplace_back((i + 1) % 40, i, 1.0);
    }
    oom::Sweep constructors("sparse constructors");
    constructors.run([&] {
        return ends([&] {
            Sparse a(40, 40);
            a.setFromTriplets(entries.begin(), entries.end());
            const Sparse copy(a), transposed(a.transpose()), product(a * copy), sum(a + product);
            const RowSparse rows(sum);
            Sparse reserved(40, 40);
            reserved.reserve(Eigen::VectorXi::Constant(40, 3));
            reserved.insert(3, 4) = 1;
            reserved.reserve(Eigen::VectorXi::Constant(40, 6));
            reserved.uncompress();
        });
    });
    failed += constructors.report();

    oom::Sweep reuse("sparse resize");
    reuse.run([&] {
        bool right = true;
        return ends([&] {
                   Sparse a(40, 40);
                   ends([&] { a.resize(60, 60); });
                   ends([&] { a.resize(40, 40); });
                   right = a.nonZeros() == 0;
               }) &&
               right;
    });
    failed += reuse.report();

    oom::Sweep factors("sparse factor");
    factors.run([&] {
        return ends([&] {
            Sparse a(40, 40);
            a.setFromTriplets(entries.begin(), entries.end());
            Eigen::SimplicialLDLT<Sparse> factor(a);
            const Vector x = factor.solve(Vector(Vector::Ones(40)));
            Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
            Eigen::AMDOrdering<int>()(a, order);
        });
    });
    failed += factors.report();
    return failed;
}

}  // namespace

int main() {
    if (!oom::available()) {
        std::puts("the malloc family cannot be replaced in this build: skipped");
        return 0;
    }
    return sweep_dense() + sweep_decompositions() + sweep_sparse() == 0 ? 0 : 1;
}
