#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>

#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// Points that lie less than this behind the outermost one reach out nearly as far [m]: pads give
/// by some of it, and the rest is the noise of depth cameras.
inline constexpr double kNearlyAsFar = 0.003;

/// How much of the area of two pads has something between them, and at how much of it that reaches
/// out as far as elsewhere. Noise and edges fill little of it, and slopes reach out at few places.
class PadCover {
 public:
  /// @param x  middle of the pads along x [m]
  /// @param tip  how far the tips reach along z [m]
  PadCover(double x, double tip, const Gripper& gripper);

  /// Adds a point between the pads, given along the axes of G [m].
  void add(const Eigen::Vector3d& p_G) {
    const double across = (p_G.x() - x_min_) / x_edge_, along = (p_G.z() - z_min_) / z_edge_;
    if (!(across >= 0.0 && across < kAcross && along >= 0.0 && along < kAlong)) return;
    // Truncation rounds down, since both are positive. Unlike std::floor(), it is no function call
    // on plain x86-64, and unlike arrays, pointers do not check each access.
    const int cell = static_cast<int>(along) * kAcross + static_cast<int>(across);
    double &low = low_.data()[cell], &high = high_.data()[cell];
    low = std::min(low, p_G.y());
    high = std::max(high, p_G.y());
  }
  /// Returns the share of the area between which there are points.
  double filled() const;
  /// Returns the share of the area at which points reach out nearly as far as the outermost one
  /// between the pads, the lesser of the two pads.
  double flat() const;

 private:
  // The cells of the Franka Hand's pads are 5.8 mm by 3 mm, about as large as what stereo cameras
  // resolve.
  static constexpr int kAcross = 3, kAlong = 6;

  double x_min_, z_min_, x_edge_, z_edge_;
  std::array<double, static_cast<std::size_t>(kAcross) * kAlong> low_, high_;
};

}  // namespace quadrille
