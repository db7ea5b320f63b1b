#include "targets/spread.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace quadrille {
namespace {

/// Returns the angle between two unit directions [rad].
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

double difference(const Grasp& a, const Grasp& b, double reach) {
  constexpr double kRightAngle = 0.5 * std::numbers::pi;
  const Eigen::Matrix3d &R = a.X_CG.linear(), &S = b.X_CG.linear();
  const double apart = (a.X_CG.translation() - b.X_CG.translation()).norm() / reach;
  const double approach = angle_between(R.col(2), S.col(2)) / kRightAngle;
  const double turn = angle_between(R.col(1), S.col(1));
  // The hand may be turned by half a turn about its approach: it then holds the same way.
  const double closing = std::min(turn, std::numbers::pi - turn) / kRightAngle;
  return std::min(1.0, std::max({apart, approach, closing}));
}

std::vector<Grasp> spread(const std::vector<Grasp>& grasps, std::size_t count, double reach) {
  // The difference of each grasp to the most similar one that is picked.
  std::vector<double> unlike(grasps.size(), 1.0);
  std::vector<char> picked(grasps.size(), 0);
  std::vector<Grasp> picks;
  while (picks.size() < std::min(count, grasps.size())) {
    std::size_t best = grasps.size();
    double most = 0.0;
    for (std::size_t n = 0; n < grasps.size(); ++n) {
      const double value = grasps[n].score * unlike[n];
      const bool better = best == grasps.size() || value > most;
      if (!picked[n] && better) most = value, best = n;
    }
    picked[best] = 1;
    picks.push_back(grasps[best]);
    for (std::size_t n = 0; n < grasps.size(); ++n) {
      unlike[n] = std::min(unlike[n], difference(grasps[n], grasps[best], reach));
    }
  }
  return picks;
}

}  // namespace quadrille
