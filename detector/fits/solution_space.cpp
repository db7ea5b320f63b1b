#include "fits/solution_space.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <stdexcept>

namespace quadrille {

SolutionSpace solution_space(const LinearSystem& system, double tolerance) {
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(system.A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  svd.setThreshold(tolerance);
  SolutionSpace space;
  space.rank = svd.rank();
  space.p = svd.solve(system.n);
  space.null_space = svd.matrixV().rightCols(system.A.cols() - space.rank);
  return space;
}

Eigen::VectorXd solve_lambda(const SolutionSpace& space, const LinearSystem& further) {
  const Eigen::MatrixXd M = further.A * space.null_space;
  return M.completeOrthogonalDecomposition().solve(further.n - further.A * space.p);
}

double solve_single_lambda(const SolutionSpace& space, const LinearSystem& further) {
  if (space.null_space.cols() != 1) {
    throw std::invalid_argument("solve_single_lambda: the null space has not one dimension");
  }
  const Eigen::VectorXd m = further.A * space.null_space.col(0);
  return m.dot(further.n - further.A * space.p) / m.squaredNorm();
}

}  // namespace quadrille
