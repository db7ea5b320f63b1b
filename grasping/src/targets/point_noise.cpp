#include "targets/point_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

// Points farther than this from the surface belong to something else [m].
constexpr double kMaxDistance = 0.015;
// Number of points of a cloud that are examined; of these a few hundred lie on a target, which is
// enough.
constexpr std::size_t kMaxPoints = 40000;
// Standard deviation of a normal distribution divided by the median of its absolute values.
constexpr double kSigmaPerMedian = 1.4826;

}  // namespace

double point_noise(const Detection& detection, const CloudRuns& cloud) {
  const Eigen::Isometry3d X_QC = detection.X_CQ.inverse();
  Eigen::AlignedBox3d near_Q = detection.extent_Q;
  near_Q.min().array() -= kMaxDistance;
  near_Q.max().array() += kMaxDistance;
  const std::size_t step = cloud.points_C().size() / kMaxPoints + 1;
  std::vector<double> distances;
  cloud.each_in(with_rounding(near_Q.transformed(detection.X_CQ)), [&](std::size_t n) {
    if (n % step != 0) return;
    const Eigen::Vector3d p_C = cloud.points_C()[n].cast<double>();
    if (!near_Q.contains(X_QC * p_C)) return;
    const double distance = std::abs(detection.Q_C.distance(p_C));
    if (distance < kMaxDistance) distances.push_back(distance);
  });
  if (distances.empty()) return 0.0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return kSigmaPerMedian * *middle;
}

}  // namespace quadrille
