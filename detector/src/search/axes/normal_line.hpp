#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace quadrille {

/// The line along the normal of a sample, projected into the plane across an axis, which is the z
/// axis of its frame.
struct NormalLine {
  /// @param x  position of the sample in the frame of the axis
  /// @param n  its unit normal there
  NormalLine(const Eigen::Vector3f& x, const Eigen::Vector3f& n)
      : at(x.head<2>()), sine(n.head<2>().norm()), along(n.head<2>() / sine) {}

  /// False if the normal is nearly parallel to the axis, as on lids and supports.
  bool has_direction() const { return sine >= 0.35f; }

  /// Distance at which the line passes a point of the plane, positive on one side.
  float miss(const Eigen::Vector2f& centre = Eigen::Vector2f::Zero()) const {
    return (at - centre).x() * along.y() - (at - centre).y() * along.x();
  }

  /// True if the line passes near a point of the plane, as the normals of a surface do that is
  /// revolved about it: within 1.3 cells, or .12 of the sample's distance.
  bool meets_axis(float cell, const Eigen::Vector2f& centre = Eigen::Vector2f::Zero()) const {
    return std::abs(miss(centre)) <= std::max(1.3f * cell, 0.12f * (at - centre).norm());
  }

  Eigen::Vector2f at;
  /// Sine between normal and axis.
  float sine;
  Eigen::Vector2f along;
};

}  // namespace quadrille
