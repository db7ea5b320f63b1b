#include "poses.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

Placed place(const std::vector<Eigen::Isometry3d>& poses, const std::vector<Placed>& more) {
  Placed placed;
  for (const Eigen::Isometry3d& X : poses) placed.centre += X.translation();
  for (const Placed& one : more) placed.Q += one.weight * one.X.matrix() * one.Q;
  placed.weight = static_cast<double>(poses.size());
  placed.centre /= placed.weight;
  placed.X = poses.back();
  placed.centre = placed.X.inverse() * placed.centre;
  return placed;
}

double decompose(const Eigen::MatrixXd& A) {
  const Eigen::MatrixXd S = A.transpose() * A;
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 10, 10>;
  const Small small = S.topLeftCorner(10, 10), one = Small::Identity(10, 10);
  const Small inverse = Eigen::LDLT<Small>(small).solve(one);
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(A);
  const Eigen::MatrixXd Q = qr.householderQ() * Eigen::MatrixXd::Identity(A.rows(), A.cols());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> all(S);
  const Eigen::Matrix4d four = S.topLeftCorner<4, 4>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> some(four);
  return (small * inverse - one).norm() +
         (Q.transpose() * Q - Eigen::MatrixXd::Identity(A.cols(), A.cols())).norm() +
         (S * all.eigenvectors() - all.eigenvectors() * all.eigenvalues().asDiagonal()).norm() +
         (four * some.eigenvectors() - some.eigenvectors() * some.eigenvalues().asDiagonal())
             .norm();
}
