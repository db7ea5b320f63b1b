#include "lab/experiments/true_sphere.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace quadrille::experiments {
namespace {

// Gauss and Newton converge in a few steps from the algebraic fit.
constexpr int kSteps = 20;

/// The least-squares solution of |p|² = 2 c·p + (r² − |c|²), which is linear in the unknowns.
FittedSphere algebraic_fit(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector4d row = (Eigen::Vector4d() << 2.0 * p, 1.0).finished();
    A += row * row.transpose();
    b += p.squaredNorm() * row;
  }
  const Eigen::Vector4d x = A.ldlt().solve(b);
  FittedSphere sphere;
  sphere.centre = x.head<3>();
  sphere.radius = std::sqrt(x[3] + sphere.centre.squaredNorm());
  return sphere;
}

}  // namespace

FittedSphere fit_sphere(const std::vector<Eigen::Vector3d>& points) {
  FittedSphere sphere = algebraic_fit(points);
  for (int step = 0; step < kSteps; ++step) {
    Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
    Eigen::Vector4d b = Eigen::Vector4d::Zero();
    for (const Eigen::Vector3d& p : points) {
      const Eigen::Vector3d d = p - sphere.centre;
      const double length = d.norm();
      // The distance |p − c| − r and its derivatives by c and r.
      const Eigen::Vector4d row = (Eigen::Vector4d() << -d / length, -1.0).finished();
      A += row * row.transpose();
      b -= (length - sphere.radius) * row;
    }
    const Eigen::Vector4d x = A.ldlt().solve(b);
    sphere.centre += x.head<3>();
    sphere.radius += x[3];
  }
  return sphere;
}

}  // namespace quadrille::experiments
