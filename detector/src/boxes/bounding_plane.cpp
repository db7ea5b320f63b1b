#include "boxes/bounding_plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "boxes/face.hpp"

namespace quadrille {
namespace {

/// Distance from a corner along a direction to the plane; nullopt if the ray misses the plane's
/// extent [m].
std::optional<double> distance_to(const Detection& plane, const Eigen::Vector3d& n_C,
                                  const Eigen::Vector3d& corner_C, const Eigen::Vector3d& out_C) {
  const double distance = n_C.dot(plane.X_CQ.translation() - corner_C) / n_C.dot(out_C);
  const Eigen::Vector3d at_Q = plane.X_CQ.inverse() * Eigen::Vector3d(corner_C + distance * out_C);
  const auto within = [&](int i) {
    return at_Q[i] >= plane.extent_Q.min()[i] && at_Q[i] <= plane.extent_Q.max()[i];
  };
  if (!within(0) || !within(1)) return std::nullopt;
  return distance;
}

}  // namespace

PlaneStop stop_at_plane(const std::vector<Eigen::Vector3d>& corners_C, const Eigen::Vector3d& out_C,
                        const std::vector<const Detection*>& planes, double slack) {
  PlaneStop stop{std::numeric_limits<double>::infinity(), false};
  for (const Detection* plane : planes) {
    const Eigen::Vector3d n_C = outward_normal(*plane);
    const double facing = -n_C.dot(out_C);
    if (facing < kMinCosine) continue;
    const bool parallel = facing > std::cos(kMaxSkew);
    // The nearest corner stops the end. On a parallel plane all corners meet at once, and their
    // mean is more accurate.
    double nearest = std::numeric_limits<double>::infinity(), sum = 0.0;
    int met = 0;
    for (const Eigen::Vector3d& corner_C : corners_C) {
      const std::optional<double> distance = distance_to(*plane, n_C, corner_C, out_C);
      if (!distance) continue;
      nearest = std::min(nearest, *distance);
      sum += *distance;
      ++met;
    }
    if (met == 0) continue;
    const double distance = parallel ? sum / met : nearest;
    if (distance > -slack && distance < stop.distance) stop = {distance, parallel};
  }
  return stop;
}

}  // namespace quadrille
