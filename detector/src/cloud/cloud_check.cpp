#include "cloud/cloud_check.hpp"

#include <algorithm>
#include <cmath>

#include "base/quantile.hpp"
#include "base/symmetric_eigen.hpp"
#include "cloud/some_points.hpp"

namespace quadrille {
namespace {

// If the standard deviation of the points is larger [m], the coordinates are probably not in
// metres.
constexpr double kWidest = 5.0;
// If it is smaller [m], metres were probably taken for millimetres.
constexpr double kNarrowest = 1e-3 * kWidest;
// Larger coordinates are no measurement, and their squares would overflow single precision.
constexpr double kMax = 1e9;
const char* const kTooLarge = "coordinates are too large to be a measurement in metres";
// From this coordinate on [m], single precision has steps of half a millimetre.
constexpr double kCoarse = 4096.0;

/// Value of a measure that a given share of the points does not exceed.
template <class Measure>
double quantile(const std::vector<Eigen::Vector3d>& points, double share, Measure&& measure) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const Eigen::Vector3d& p : points) values.push_back(measure(p));
  return quadrille::quantile(values, share);
}

/// Variances of the points along their principal axes in ascending order.
Eigen::Vector3d spread_of(const std::vector<Eigen::Vector3d>& points,
                          const Eigen::Vector3d& centre) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d x = p - centre;
    sum += x;
    square += x * x.transpose();
  }
  const double n = static_cast<double>(points.size());
  const Eigen::Vector3d mean = sum / n;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
      Eigen::Matrix3d(square / n - mean * mean.transpose()), Eigen::EigenvaluesOnly);
  return eigen.eigenvalues();
}

bool coincide(const Eigen::Vector3d& spread) { return !(spread[2] > 1e-18); }
bool on_a_line(const Eigen::Vector3d& spread) { return spread[1] < 1e-8 * spread[2]; }

}  // namespace

CloudCheck check_cloud(const CloudView& given) {
  CloudCheck check;
  check.range = check_range(given);
  if (check.range.far > 0) check.warnings.push_back(check.range.warning());
  if (check.range.near < kMinPoints) {
    check.warnings.push_back(check.range.far < kMinPoints
                                 ? "only " + std::to_string(check.range.near) +
                                       " finite points; a surface needs at least " +
                                       std::to_string(kMinPoints)
                                 : kTooLarge);
    return check;
  }
  const CloudView cloud = check.range.kept(given);
  const std::vector<Eigen::Vector3d> some = some_of(cloud.points);
  if (some.empty()) {
    check.usable = true;
    return check;
  }
  check.centre = middle_of(some);
  if (!(check.centre.norm() < kMax)) {
    check.warnings.emplace_back(kTooLarge);
    return check;
  }
  const Eigen::Vector3d spread = spread_of(some, check.centre);
  if (check.centre.cwiseAbs().maxCoeff() > kCoarse) {
    check.warnings.emplace_back(
        "coordinates of several kilometres are stored to no better than half a millimetre: "
        "subtract an offset first");
  }
  const auto depth = [&](const auto& p) { return (p - cloud.viewpoint).norm(); };
  const double usual_depth = quantile(some, 0.5, depth);
  if (usual_depth > kFarthest) {
    check.warnings.emplace_back(
        spread[2] > kWidest * kWidest
            ? "half of the points are more than 50 m away: the coordinates look like "
              "millimetres (--unit mm) or centimetres; give metres"
            : "half of the points are more than 50 m from the viewpoint: name the sensor's "
              "position");
  }
  if (coincide(spread)) {
    check.warnings.emplace_back("all points coincide");
  } else if (on_a_line(spread)) {
    check.warnings.emplace_back("all points lie on a line");
  } else {
    check.usable = true;
    // If the points are also too near the sensor, contradict_viewpoint() already has this warning.
    if (spread[2] < kNarrowest * kNarrowest && usual_depth > kNearest) {
      check.warnings.push_back(
          std::string("the points lie within some millimetres of each other; ") +
          kTakenForMillimetres);
    }
  }
  return check;
}

}  // namespace quadrille
