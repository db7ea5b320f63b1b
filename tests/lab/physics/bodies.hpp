#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "lab/physics/true_body.hpp"

namespace quadrille::test {

/// A body whose s² is p[0] + p[1] z + p[2] z², around its axis at the origin.
inline physics::TrueBody body_of(const char* type, double a, double b, const Eigen::Vector3d& p,
                                 double z_min, double z_max) {
  physics::TrueBody body;
  body.type = type;
  body.a = a;
  body.b = b;
  body.p = p;
  body.box_S = {Eigen::Vector3d(0, 0, z_min), Eigen::Vector3d(0, 0, z_max)};
  double most = 0.0;
  for (int i = 0; i <= 100; ++i) {
    most = std::max(most, body.scale(z_min + 0.01 * i * (z_max - z_min)));
  }
  body.box_S.min().head<2>() = Eigen::Vector2d(-a * most, -b * most);
  body.box_S.max().head<2>() = Eigen::Vector2d(a * most, b * most);
  return body;
}

inline physics::TrueBody ball(double radius) {
  return body_of("sphere", 1.0, 1.0, {radius * radius, 0.0, -1.0}, -radius, radius);
}

inline physics::TrueBody ellipsoid(double a, double b, double c) {
  return body_of("ellipsoid", a, b, {1.0, 0.0, -1.0 / (c * c)}, -c, c);
}

inline physics::TrueBody cylinder(double a, double b, double half_length) {
  return body_of(a == b ? "cylinder" : "elliptic_cylinder", a, b, {1.0, 0.0, 0.0}, -half_length,
                 half_length);
}

/// Of a half angle's tangent, cut between two distances from the apex.
inline physics::TrueBody cone(double tangent, double low, double high) {
  return body_of("cone", 1.0, 1.0, {0.0, 0.0, tangent * tangent}, low, high);
}

/// z = (x² + y²)/4f, up to a height.
inline physics::TrueBody dome(double focal, double height) {
  const double a = std::sqrt(4.0 * focal);
  return body_of("elliptic_paraboloid", a, a, {0.0, 1.0, 0.0}, 0.0, height);
}

inline physics::TrueBody vase(double a, double c, double half_height) {
  return body_of("hyperboloid_one_sheet", a, a, {1.0, 0.0, 1.0 / (c * c)}, -half_height,
                 half_height);
}

inline physics::TrueBody block(const Eigen::Vector3d& half) {
  physics::TrueBody body;
  body.type = "box";
  body.is_box = true;
  body.box_S = {Eigen::Vector3d(-half), half};
  return body;
}

/// One of each profile.
inline std::vector<physics::TrueBody> round_bodies() {
  return {ball(0.03),
          ellipsoid(0.04, 0.03, 0.02),
          cylinder(0.03, 0.03, 0.05),
          cylinder(0.03, 0.02, 0.05),
          cone(0.3, 0.05, 0.15),
          cone(0.4, 0.0, 0.1),
          dome(0.01, 0.05),
          vase(0.02, 0.04, 0.05)};
}

}  // namespace quadrille::test
