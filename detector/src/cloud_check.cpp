#include "quadrille/detector/cloud_check.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

constexpr std::size_t kLeastPoints = 50;
// Nothing to grasp is this far away, but in millimetres most things are.
constexpr float kFarthest = 50.0f;
// Larger coordinates are no measurement; their squares would overflow single precision.
constexpr float kLargest = 1e9f;

std::size_t count_finite(const std::vector<Eigen::Vector3f>& points) {
  // x - x is zero unless x is NaN or infinite. Most runs are finite as a whole.
  constexpr std::size_t kRun = 16;
  using Run = Eigen::Map<const Eigen::Array<float, 3 * kRun, 1>>;
  std::size_t finite = 0, start = 0;
  for (; start + kRun <= points.size(); start += kRun) {
    const Run run(points[start].data());
    if ((run - run).sum() == 0.0f) {
      finite += kRun;
      continue;
    }
    for (std::size_t i = start; i < start + kRun; ++i) finite += points[i].allFinite();
  }
  for (; start < points.size(); ++start) finite += points[start].allFinite();
  return finite;
}

}  // namespace

CloudCheck check_cloud(const PointCloud& cloud) {
  CloudCheck check;
  check.finite = count_finite(cloud.points);
  std::vector<float> distance;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  double looked = 0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  const std::size_t stride = std::max<std::size_t>(1, cloud.points.size() / 5000);
  for (std::size_t i = 0; i < cloud.points.size(); i += stride) {
    const Eigen::Vector3d p = cloud.points[i].cast<double>();
    if (!p.allFinite()) continue;
    if (looked == 0) origin = p;
    const Eigen::Vector3d x = p - origin;
    looked += 1, sum += x, square += x * x.transpose();
    distance.push_back(static_cast<float>((p - cloud.viewpoint).norm()));
  }
  if (check.finite < kLeastPoints) {
    check.warnings.push_back("only " + std::to_string(check.finite) +
                             " finite points; a surface needs at least " +
                             std::to_string(kLeastPoints));
    return check;
  }
  if (distance.empty()) {
    check.usable = true;
    return check;
  }
  const auto middle = distance.begin() + static_cast<std::ptrdiff_t>(distance.size() / 2);
  std::nth_element(distance.begin(), middle, distance.end());
  if (!(*middle < kLargest)) {
    check.warnings.push_back("coordinates are too large to be a measurement in metres");
    return check;
  }
  if (*middle > kFarthest) {
    check.warnings.push_back(
        "half of the points are more than 50 m away: the coordinates look like "
        "millimetres; give metres");
  }
  const Eigen::Vector3d mean = sum / looked;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
      Eigen::Matrix3d(square / looked - mean * mean.transpose()));
  const Eigen::Vector3d spread = eigen.eigenvalues();
  if (!(spread[2] > 1e-18)) {
    check.warnings.push_back("all points coincide");
  } else if (spread[1] < 1e-8 * spread[2]) {
    check.warnings.push_back("all points lie on a line");
  } else {
    check.usable = true;
  }
  return check;
}

}  // namespace quadrille
