#pragma once

#include <cmath>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::test {

/// A detection without error, of what a camera at the origin of C would see of a quadric.
/// @param extent_Q  of what was seen, in the canonical frame
inline Detection exact_detection(QuadricType type, const Eigen::Isometry3d& X_CQ,
                                 const std::vector<Dimension>& dimensions,
                                 const Eigen::AlignedBox3d& extent_Q) {
  Detection detection;
  CanonicalForm form{type, X_CQ, {}};
  for (const Dimension& d : dimensions) {
    if (d.name != "length" && d.name != "width" && d.name != "height") {
      form.dimensions.emplace_back(d.name, d.value);
    }
  }
  detection.type = type;
  detection.Q_C = from_canonical(form).normalized();
  detection.X_CQ = X_CQ;
  detection.dimensions = dimensions;
  detection.extent_Q = extent_Q;
  detection.rms = 0.001;
  detection.score = 1.0;
  return detection;
}

/// The canonical frame at a point, its z against the line of sight.
inline Eigen::Isometry3d facing(const Eigen::Vector3d& p_C) {
  Eigen::Isometry3d X_CQ(Eigen::Translation3d{p_C});
  X_CQ.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), -p_C).matrix();
  return X_CQ;
}

/// The front of a ball.
inline Detection exact_ball(const Eigen::Vector3d& p_C, double radius) {
  return exact_detection(
      QuadricType::kSphere, facing(p_C), {{"radius", radius, 0.001}},
      {Eigen::Vector3d(-radius, -radius, 0.2 * radius), Eigen::Vector3d(radius, radius, radius)});
}

/// The same as an ellipsoid whose unseen semi-axis is a guess.
inline Detection exact_ellipsoid(const Eigen::Vector3d& p_C, double radius, double guess) {
  // The near end is that of the ball.
  const Eigen::Isometry3d X_CQ = facing(p_C + (guess - radius) * p_C.normalized());
  return exact_detection(
      QuadricType::kEllipsoid, X_CQ,
      {{"a", radius, 0.001}, {"b", radius, 0.001}, {"c", guess, 0.5 * guess}},
      {Eigen::Vector3d(-radius, -radius, 0.5 * guess), Eigen::Vector3d(radius, radius, guess)});
}

/// The front of a mantle that stands along y, its middle at p_C.
inline Detection exact_cylinder(const Eigen::Vector3d& p_C, double radius, double length) {
  Eigen::Isometry3d X_CQ(Eigen::Translation3d{p_C});
  X_CQ.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return exact_detection(QuadricType::kCylinder, X_CQ,
                         {{"radius", radius, 0.001}, {"length", length, 0.01}},
                         {Eigen::Vector3d(-radius, 0.2 * radius, -0.5 * length),
                          Eigen::Vector3d(radius, radius, 0.5 * length)});
}

/// A rectangle across the line of sight.
inline Detection exact_plane(const Eigen::Vector3d& p_C, double width, double height) {
  Eigen::Isometry3d X_CQ(Eigen::Translation3d{p_C});
  X_CQ.linear() << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  return exact_detection(QuadricType::kPlane, X_CQ,
                         {{"width", width, 0.01}, {"height", height, 0.01}},
                         {Eigen::Vector3d(-0.5 * width, -0.5 * height, -0.001),
                          Eigen::Vector3d(0.5 * width, 0.5 * height, 0.001)});
}

}  // namespace quadrille::test
