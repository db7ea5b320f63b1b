#include "views/outlook.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "base/quantile.hpp"

namespace quadrille {

Outlook outlook_of(const Sight& sight, const Eigen::Isometry3d& X_WC) {
  std::vector<float> seen;
  for (const float w : sight.w) {
    if (w > 0.0f) seen.push_back(w);
  }
  const double depth = seen.empty() ? 1.0 : 1.0 / median(seen);
  const Eigen::Isometry3d X_WV = X_WC * sight.X_VC.inverse().cast<double>();
  return {X_WV.translation(), X_WV * Eigen::Vector3d(0.0, 0.0, depth)};
}

double angle_between(const Outlook& a, const Outlook& b) {
  // Places are different if they lie farther apart than this share of their distance from the eye.
  constexpr double kOtherPlace = 0.5;
  const Eigen::Vector3d to_a = a.eye_W - a.place_W, to_b = b.eye_W - a.place_W;
  if ((a.place_W - b.place_W).norm() > kOtherPlace * to_a.norm()) {
    return std::numeric_limits<double>::infinity();
  }
  return std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b));
}

}  // namespace quadrille
