#include "cloud/cloud_check.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <span>

#include "base/quantile.hpp"

namespace quadrille {
namespace {

constexpr std::size_t kMinPoints = 50;
// Nothing to grasp is this far away, but in millimetres most things are.
constexpr double kFarthest = 50.0;
// A scene of which the standard deviation is larger [m].
constexpr double kWidest = 5.0;
// Larger coordinates are no measurement; their squares would overflow single precision.
constexpr double kMax = 1e9;
// From here on [m] single precision steps by half a millimetre.
constexpr double kCoarse = 4096.0;
// Points so many times as far from the centre as half of them are outliers.
constexpr double kOutlier = 100.0;

std::size_t count_finite(std::span<const Eigen::Vector3f> points) {
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

/// Finite points spread evenly over the cloud, some thousands.
std::vector<Eigen::Vector3d> some_of(std::span<const Eigen::Vector3f> points) {
  std::vector<Eigen::Vector3d> some;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / 5000);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    if (points[i].allFinite()) some.push_back(points[i].cast<double>());
  }
  return some;
}

/// Value of a measure that a share of the points do not exceed.
template <class Measure>
double quantile(const std::vector<Eigen::Vector3d>& points, double share, Measure&& measure) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const Eigen::Vector3d& p : points) values.push_back(measure(p));
  return quadrille::quantile(values, share);
}

/// Variances along their principal axes, ascending, of the points within a distance of the centre.
Eigen::Vector3d spread_within(double distance, const std::vector<Eigen::Vector3d>& points,
                              const Eigen::Vector3d& centre) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  double n = 0;
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d x = p - centre;
    if (x.norm() > distance) continue;
    n += 1, sum += x, square += x * x.transpose();
  }
  const Eigen::Vector3d mean = sum / n;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
      Eigen::Matrix3d(square / n - mean * mean.transpose()), Eigen::EigenvaluesOnly);
  return eigen.eigenvalues();
}

bool coincide(const Eigen::Vector3d& spread) { return !(spread[2] > 1e-18); }
bool on_a_line(const Eigen::Vector3d& spread) { return spread[1] < 1e-8 * spread[2]; }

/// Variances of the points along their principal axes, ascending. A few far outliers would make a
/// line of any cloud, and do not count unless nearly all others coincide or lie on a line.
Eigen::Vector3d spread_of(const std::vector<Eigen::Vector3d>& points,
                          const Eigen::Vector3d& centre) {
  const double usual = quantile(points, 0.9, [&](const auto& p) { return (p - centre).norm(); });
  Eigen::Vector3d spread = spread_within(kOutlier * usual, points, centre);
  if (!coincide(spread) && !on_a_line(spread)) return spread;
  return spread_within(kMax, points, centre);
}

}  // namespace

CloudCheck check_cloud(const CloudView& cloud) {
  CloudCheck check;
  check.finite = count_finite(cloud.points);
  if (check.finite < kMinPoints) {
    check.warnings.push_back("only " + std::to_string(check.finite) +
                             " finite points; a surface needs at least " +
                             std::to_string(kMinPoints));
    return check;
  }
  const std::vector<Eigen::Vector3d> some = some_of(cloud.points);
  if (some.empty()) {
    check.usable = true;
    return check;
  }
  for (int axis = 0; axis < 3; ++axis) {
    check.centre[axis] = quantile(some, 0.5, [axis](const auto& p) { return p[axis]; });
  }
  if (!(check.centre.norm() < kMax)) {
    check.warnings.emplace_back("coordinates are too large to be a measurement in metres");
    return check;
  }
  const Eigen::Vector3d spread = spread_of(some, check.centre);
  if (check.centre.cwiseAbs().maxCoeff() > kCoarse) {
    check.warnings.emplace_back(
        "coordinates of several kilometres are stored to no better than half a millimetre: "
        "subtract an offset first");
  }
  const auto range = [&](const auto& p) { return (p - cloud.viewpoint).norm(); };
  if (quantile(some, 0.5, range) > kFarthest) {
    check.warnings.emplace_back(
        spread[2] > kWidest * kWidest
            ? "half of the points are more than 50 m away: the coordinates look like "
              "millimetres or centimetres; give metres"
            : "half of the points are more than 50 m from the viewpoint: name the sensor's "
              "position");
  }
  if (coincide(spread)) {
    check.warnings.emplace_back("all points coincide");
  } else if (on_a_line(spread)) {
    check.warnings.emplace_back("all points lie on a line");
  } else {
    check.usable = true;
  }
  return check;
}

}  // namespace quadrille
