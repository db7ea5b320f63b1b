#include "base/symmetric_eigen.hpp"

template class Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>;
template class Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;

template Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>& Eigen::SelfAdjointEigenSolver<
    Eigen::Matrix2d>::compute(const Eigen::EigenBase<Eigen::Matrix2d>& matrix, int options);
template Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>& Eigen::SelfAdjointEigenSolver<
    Eigen::Matrix3d>::compute(const Eigen::EigenBase<Eigen::Matrix3d>& matrix, int options);
