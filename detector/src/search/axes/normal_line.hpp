#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace quadrille {

/// The line along the normal of a sample, projected into the plane across an axis, which is the z
/// axis of its frame.
struct NormalLine {
  /// Least sine between normal and axis. Below it noise decides on the projected direction.
  static constexpr float kMinSine = 0.35f;
  /// A line meets an axis if it passes it within so many cells, which allows for the error of a
  /// position, or within this share of its sample's distance, for the error of a normal [rad].
  static constexpr float kMaxMissCells = 1.3f, kMaxMissShare = 0.12f;

  /// @param x  position of the sample in the frame of the axis
  /// @param n  its unit normal there
  NormalLine(const Eigen::Vector3f& x, const Eigen::Vector3f& n)
      : at(x.head<2>()), sine(n.head<2>().norm()), along(n.head<2>() / sine) {}

  /// False if the normal is nearly parallel to the axis, as on lids and supports.
  bool has_direction() const { return sine >= kMinSine; }

  /// Distance at which the line passes a point of the plane, positive on one side.
  float miss(const Eigen::Vector2f& centre = Eigen::Vector2f::Zero()) const {
    return (at - centre).x() * along.y() - (at - centre).y() * along.x();
  }

  /// True if the line passes near a point of the plane, as those of a surface do that is revolved
  /// about it.
  bool meets_axis(float cell, const Eigen::Vector2f& centre = Eigen::Vector2f::Zero()) const {
    return std::abs(miss(centre)) <=
           std::max(kMaxMissCells * cell, kMaxMissShare * (at - centre).norm());
  }

  Eigen::Vector2f at;
  /// Sine between normal and axis.
  float sine;
  Eigen::Vector2f along;
};

}  // namespace quadrille
