// Eigen's decompositions, compiled once for the whole library: decompositions.cpp defines what this
// header declares. Every room includes it through the precompiled header, so nobody has to; a file
// that is compiled without still works, and compiles a decomposition of its own. It holds for
// arguments that are a Matrix: write SelfAdjointEigenSolver<Matrix>(Matrix(a * b)), which costs
// next to nothing, because the solver copies it anyway.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

#define MIEN_DECOMPOSITIONS(prefix)                                                                \
    prefix template Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>&                                \
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>::compute(                                       \
        const Eigen::EigenBase<Eigen::MatrixXd>&, int);                                            \
    prefix template Eigen::LLT<Eigen::MatrixXd>& Eigen::LLT<Eigen::MatrixXd>::compute(             \
        const Eigen::EigenBase<Eigen::MatrixXd>&);                                                 \
    prefix template void Eigen::LLT<Eigen::MatrixXd>::_solve_impl(const Eigen::MatrixXd&,          \
                                                                  Eigen::MatrixXd&) const;         \
    prefix template void Eigen::LLT<Eigen::MatrixXd>::_solve_impl(const Eigen::VectorXd&,          \
                                                                  Eigen::VectorXd&) const;         \
    prefix template Eigen::LDLT<Eigen::MatrixXd>& Eigen::LDLT<Eigen::MatrixXd>::compute(           \
        const Eigen::EigenBase<Eigen::MatrixXd>&);                                                 \
    prefix template void Eigen::LDLT<Eigen::MatrixXd>::_solve_impl(const Eigen::MatrixXd&,         \
                                                                   Eigen::MatrixXd&) const;        \
    prefix template void Eigen::LDLT<Eigen::MatrixXd>::_solve_impl(const Eigen::VectorXd&,         \
                                                                   Eigen::VectorXd&) const;        \
    prefix template void Eigen::HouseholderQR<Eigen::MatrixXd>::computeInPlace();                  \
    prefix template Eigen::JacobiSVD<Eigen::Matrix3d>& Eigen::JacobiSVD<Eigen::Matrix3d>::compute( \
        const Eigen::Matrix3d&, unsigned int);

MIEN_DECOMPOSITIONS(extern)
