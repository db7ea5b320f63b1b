#pragma once

#include <Eigen/Eigenvalues>

// Eigen's decompositions of small symmetric matrices. Compiling one takes some five seconds, so
// they are compiled once, in symmetric_eigen.cpp.

extern template class Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>;
extern template class Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;

extern template Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>& Eigen::SelfAdjointEigenSolver<
    Eigen::Matrix2d>::compute(const Eigen::EigenBase<Eigen::Matrix2d>& matrix, int options);
extern template Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>& Eigen::SelfAdjointEigenSolver<
    Eigen::Matrix3d>::compute(const Eigen::EigenBase<Eigen::Matrix3d>& matrix, int options);
