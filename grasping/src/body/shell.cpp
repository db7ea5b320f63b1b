#include "body/shell.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille {

double Shell::offset(const Eigen::Vector3d& p_C) const {
  const Eigen::Vector3d p = body.X_CQ.inverse() * p_C;
  // First-order distance: f = s(z)·(ρ − 1), in units of the semi-axes, divided by the length of its
  // gradient.
  const double s = std::max(body.scale(p.z()), 1e-6);
  const double rho = std::hypot(p.x() / body.a, p.y() / body.b);
  if (rho < 1e-9) return -std::min(body.a, body.b) * s;
  const Eigen::Vector3d gradient(p.x() / (body.a * body.a * rho), p.y() / (body.b * body.b * rho),
                                 -body.slope(p.z()));
  return (rho - s) / gradient.norm();
}

bool Shell::in_wall(const Eigen::Vector3d& p_C, double margin) const {
  const double z = (body.X_CQ.inverse() * p_C).z();
  const double off = offset(p_C);
  return z >= body.z_min - margin && z <= body.z_max + margin && off >= inner() - margin &&
         off <= outer() + margin;
}

Eigen::Vector3d Shell::point_Q(double angle, double z) const {
  const double s = body.scale(z);
  return {body.a * s * std::cos(angle), body.b * s * std::sin(angle), z};
}

Eigen::Vector3d Shell::normal_Q(double angle, double z) const {
  return Eigen::Vector3d(std::cos(angle) / body.a, std::sin(angle) / body.b, -body.slope(z))
      .normalized();
}

bool seen_from_inside(const Detection& detection, const Body& body) {
  if (body.profile == Body::Profile::kBox) return false;
  const double z = body.profile == Body::Profile::kEllipse ? 0.0 : 0.5 * (body.z_min + body.z_max);
  const Shell shell{body, false, {}};
  const Eigen::Vector3d p_C = body.X_CQ * shell.point_Q(0.0, z);
  return detection.Q_C.gradient(p_C).dot(body.X_CQ.linear() * shell.normal_Q(0.0, z)) < 0.0;
}

}  // namespace quadrille
