#include "boxes/face.hpp"

#include <algorithm>
#include <cmath>

#include "base/quantile.hpp"
#include "base/symmetric_eigen.hpp"

namespace quadrille {
namespace {

// Least tolerance of a face [m].
constexpr double kMinTolerance = 0.002;
// This many points suffice for reach().
constexpr std::size_t kMaxReachPoints = 2000;

}  // namespace

Eigen::Vector3d outward_normal(const Detection& plane) {
  const Eigen::Vector3d z_C = plane.X_CQ.linear().col(2);
  return plane.Q_C.gradient(plane.X_CQ.translation()).dot(z_C) < 0.0 ? Eigen::Vector3d(-z_C) : z_C;
}

double Face::tolerance() const { return std::clamp(3.0 * sigma, kMinTolerance, kMaxTolerance); }

double Face::pitch_along(const Eigen::Vector3d& u_C, const DirectionIndex& sight) const {
  if (!sight.single()) return pitch;
  const double along = u_C.dot((middle_C - sight.eye()).normalized());
  return pitch / std::max(kMinCosine, std::sqrt(std::max(0.0, 1.0 - along * along)));
}

std::pair<double, double> Face::reach(const Eigen::Vector3d& u_C) const {
  const std::size_t stride = 1 + points_C.size() / kMaxReachPoints;
  std::vector<double> x;
  x.reserve(points_C.size() / stride + 1);
  for (std::size_t k = 0; k < points_C.size(); k += stride) x.push_back(u_C.dot(points_C[k]));
  const double low = quantile(x, kTrimmed);
  return {low, quantile(x, 1.0 - kTrimmed)};
}

void Face::set_middle() {
  middle_C.setZero();
  for (const Eigen::Vector3d& p : points_C) middle_C += p;
  middle_C /= static_cast<double>(points_C.size());
  double farthest = 0.0;
  for (const Eigen::Vector3d& p : points_C) {
    farthest = std::max(farthest, (p - middle_C).squaredNorm());
  }
  radius = std::sqrt(farthest);
}

FacePatch patch_around(const std::vector<Eigen::Vector3d>& points, const Eigen::Matrix3d& R_CL) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) S += (p - mean) * (p - mean).transpose();
  Eigen::Vector3d n = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(S).eigenvectors().col(0);
  if (n.dot(R_CL.col(2)) < 0.0) n = -n;
  FacePatch patch;
  const Eigen::Vector3d y = n.cross(R_CL.col(0)).normalized();
  patch.X_CP.linear() << y.cross(n), y, n;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) {
    box.extend(Eigen::Vector3d(patch.X_CP.linear().transpose() * p));
  }
  Eigen::Vector3d middle = box.center();
  middle.z() = n.dot(mean);
  patch.X_CP.translation() = patch.X_CP.linear() * middle;
  patch.half = 0.5 * box.sizes().head<2>();
  return patch;
}

}  // namespace quadrille
