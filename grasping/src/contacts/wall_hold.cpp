#include "contacts/wall_hold.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

// Sine of the least steep wall, 17°: on a flatter wall, the way up to the rim is longer than a pad
// for the same rise.
constexpr double kMinWallSine = 0.3;
// Steps over which the bends of the wall are measured [rad, m]: some millimetres, which is well
// within a pad and far more than rounding.
constexpr double kTurnStep = 0.05, kRiseStep = 0.002;

const Eigen::Vector3d& seen_contact(const Shell& shell, const ContactLine& line) {
  return line.contacts_C[shell.seen_inside ? 1 : 0];
}

}  // namespace

Eigen::Vector3d along_wall(const ContactLine& line, const Eigen::Vector3d& into_C) {
  return (into_C - line.closing_C * line.closing_C.dot(into_C)).normalized();
}

double rim_above(const Shell& shell, const ContactLine& line) {
  const Eigen::Vector3d seen_Q = shell.body.X_CQ.inverse() * seen_contact(shell, line);
  const double steep = (shell.body.X_CQ.linear().transpose() * line.closing_C).head<2>().norm();
  return (shell.body.z_max - seen_Q.z()) / std::max(steep, kMinWallSine);
}

double geodesic_torsion(const Shell& shell, const ContactLine& line,
                        const Eigen::Vector3d& approach_C) {
  const Body& body = shell.body;
  const Eigen::Vector3d p = body.X_CQ.inverse() * seen_contact(shell, line);
  const double angle = std::atan2(p.y() / body.b, p.x() / body.a);
  // How much the normal turns along a path on the wall, around it or up it.
  const auto bent = [&](double angle_0, double z_0, double angle_1, double z_1) {
    const Eigen::Vector3d way = shell.point_Q(angle_1, z_1) - shell.point_Q(angle_0, z_0);
    const Eigen::Vector3d turn = shell.normal_Q(angle_1, z_1) - shell.normal_Q(angle_0, z_0);
    return turn.dot(way) / way.squaredNorm();
  };
  const double around = bent(angle - kTurnStep, p.z(), angle + kTurnStep, p.z());
  const double upward = bent(angle, p.z() - kRiseStep, angle, p.z() + kRiseStep);
  const Eigen::Vector3d into_C = -body.X_CQ.linear().col(2);
  const double along = std::min(1.0, std::abs(approach_C.dot(along_wall(line, into_C))));
  const double across = std::sqrt(1.0 - along * along);
  return std::abs(around - upward) * along * across;
}

double wall_warp(const Shell& shell, const ContactLine& line, const Eigen::Vector3d& approach_C,
                 double half_width) {
  return geodesic_torsion(shell, line, approach_C) * half_width * rim_above(shell, line);
}

}  // namespace quadrille
