#include "boxes/sight_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/quantile.hpp"
#include "quadrille/detector/cloud_checks.hpp"

namespace quadrille {

std::optional<std::pair<double, double>> clip(const Eigen::AlignedBox3d& box,
                                              const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  double from = 0.0, to = 1.0;
  for (int i = 0; i < 3; ++i) {
    const double step = b[i] - a[i];
    if (step == 0.0) {
      if (a[i] < box.min()[i] || a[i] > box.max()[i]) return std::nullopt;
      continue;
    }
    const double t0 = (box.min()[i] - a[i]) / step, t1 = (box.max()[i] - a[i]) / step;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
    if (from > to) return std::nullopt;
  }
  return std::pair(from, to);
}

std::size_t count_seen_within(const Eigen::AlignedBox3d& box_B, const Eigen::Isometry3d& X_CB,
                              const std::vector<Eigen::Vector3d>& points_C,
                              const DirectionIndex& sight) {
  const Eigen::Isometry3d X_BC = X_CB.inverse();
  const Eigen::Vector3d eye_B = X_BC * sight.eye();
  return static_cast<std::size_t>(
      std::count_if(points_C.begin(), points_C.end(), [&](const Eigen::Vector3d& p_C) {
        const Eigen::Vector3d p_B = X_BC * p_C;
        return clip(box_B, sight.single() ? eye_B : p_B, p_B).has_value();
      }));
}

double free_of_sight(const Eigen::AlignedBox3d& box_B, const Eigen::Isometry3d& X_CB, int axis,
                     int side, const std::vector<Eigen::Vector3d>& points_C,
                     const DirectionIndex& sight, std::size_t strays) {
  if (!sight.single()) return std::numeric_limits<double>::infinity();
  const double end = side > 0 ? box_B.max()[axis] : box_B.min()[axis];
  Eigen::AlignedBox3d beyond_B = box_B;
  beyond_B.min()[axis] = side > 0 ? end : end - kMaxRange;
  beyond_B.max()[axis] = side > 0 ? end + kMaxRange : end;
  const Eigen::Isometry3d X_BC = X_CB.inverse();
  const Eigen::Vector3d eye_B = X_BC * sight.eye();
  std::vector<double> free;
  for (const Eigen::Vector3d& p_C : points_C) {
    const Eigen::Vector3d p_B = X_BC * p_C;
    const auto within = clip(beyond_B, eye_B, p_B);
    if (!within) continue;
    const auto distance = [&](double t) {
      return side * (eye_B[axis] + t * (p_B[axis] - eye_B[axis]) - end);
    };
    free.push_back(std::max(0.0, std::min(distance(within->first), distance(within->second))));
  }
  if (free.size() <= strays) return std::numeric_limits<double>::infinity();
  return nth_smallest(free, strays);
}

}  // namespace quadrille
