#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace quadrille {

/// Nothing to grasp is this far away [m], but in coordinates given in millimetres most things are.
inline constexpr double kFarthest = 50.0;
/// No depth camera measures nearer than this [m].
inline constexpr double kNearest = 0.02;
/// How to mend a cloud that is a thousand times too small.
inline constexpr const char* kTakenForMillimetres =
    "if the coordinates are metres, do not read them as millimetres (--unit mm)";
/// Least number of points that can make a surface.
inline constexpr std::size_t kMinPoints = 50;

/// Step between points of which about ten thousand, spread evenly over a cloud, are looked at.
inline std::size_t step_over(std::size_t points) {
  return std::max<std::size_t>(1, points / 10000);
}

/// Returns the finite ones of these points.
std::vector<Eigen::Vector3d> some_of(std::span<const Eigen::Vector3f> points);

/// Coordinate-wise median of some points, which must not be empty.
Eigen::Vector3d middle_of(const std::vector<Eigen::Vector3d>& some);

}  // namespace quadrille
