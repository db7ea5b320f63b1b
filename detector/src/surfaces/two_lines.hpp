#pragma once

#include <limits>
#include <span>

namespace quadrille {

/// A sample in the meridian plane, through itself and an axis: its height along the axis and its
/// distance from it [m], and the variance of its distance from a profile [m²].
struct MeridianPoint {
  float z, r, variance;
};

/// Distances count up to this multiple of their deviation: what is farther away lies on something
/// else.
inline constexpr float kMaxDeviations = 3.0f;

/// The squared distance of a profile's point in multiples of its variance, as far as it counts.
inline float truncated_loss(float distance, float variance) {
  const float square = distance * distance / variance;
  return square < kMaxDeviations * kMaxDeviations ? square : kMaxDeviations * kMaxDeviations;
}

/// The profiles of a cylinder, r = radius, and of a cone about the same axis, r = r0 + slope z.
struct TwoLines {
  float radius = 0.0f, r0 = 0.0f, slope = 0.0f;
  /// Sum of the losses of the points that were looked at, each on the line that is nearer to it.
  float loss = std::numeric_limits<float>::infinity();

  float loss_on_cylinder(const MeridianPoint& p) const;
  float loss_on_cone(const MeridianPoint& p) const;
};

/// The two lines with the least loss, of those through some of the points: each line of a cylinder
/// through one, each line of a cone through two.
/// @param points  sorted by height, at least kLeastProfile
TwoLines two_lines(std::span<const MeridianPoint> points);

/// Least number of points in which lines are sought: through so many, spread evenly, lines are
/// laid.
inline constexpr std::size_t kLeastProfile = 12;

}  // namespace quadrille
