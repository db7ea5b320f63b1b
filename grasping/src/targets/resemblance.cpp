#include "targets/resemblance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace quadrille {
namespace {

// A grasp adds nothing to another one that is nearer than this [m] and turned by less than 20°.
constexpr double kMinDistance = 0.012;
const double kMaxTurnCosine = std::cos(20.0 * std::numbers::pi / 180.0);

Eigen::Vector3d middle(const std::array<Eigen::Vector3d, 2>& contacts_C) {
  return 0.5 * (contacts_C[0] + contacts_C[1]);
}

bool resembles(const Grasp& other, const Eigen::Vector3d& middle_C,
               const Eigen::Vector3d& closing_C, const Eigen::Vector3d& approach_C) {
  return (middle(other.contacts_C) - middle_C).norm() < kMinDistance &&
         other.X_CG.linear().col(2).dot(approach_C) > kMaxTurnCosine &&
         std::abs(other.X_CG.linear().col(1).dot(closing_C)) > kMaxTurnCosine;
}

}  // namespace

bool resembles_one_of(const std::vector<Grasp>& grasps, const ContactLine& line,
                      const Eigen::Vector3d& approach_C) {
  const Eigen::Vector3d here = middle(line.contacts_C);
  return std::any_of(grasps.begin(), grasps.end(), [&](const Grasp& other) {
    return resembles(other, here, line.closing_C, approach_C);
  });
}

bool resembles_one_of(const std::vector<Grasp>& others, const Grasp& grasp) {
  const Eigen::Vector3d here = middle(grasp.contacts_C);
  return std::any_of(others.begin(), others.end(), [&](const Grasp& other) {
    return resembles(other, here, grasp.X_CG.linear().col(1), grasp.X_CG.linear().col(2));
  });
}

}  // namespace quadrille
