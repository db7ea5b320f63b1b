#pragma once

namespace quadrille {

/// What unobserved space counts as while the hand moves through it.
enum class UnknownPolicy {
  kObstacle,      ///< all unknown space collides
  kTargetShadow,  ///< unknown space behind the target itself is free, the rest collides
  kFree,          ///< unknown space never collides
};

/// How grasps are planned.
struct PlanOptions {
  UnknownPolicy unknown = UnknownPolicy::kObstacle;
  /// Voxel edge of the occupancy map, and the size of the smallest things that it is to show where
  /// the sensor measured nothing [m].
  double resolution = 0.005;
  /// Friction coefficient between pads and objects.
  double friction = 0.5;
  /// Length of the straight approach to check [m].
  double approach = 0.05;
  /// Least distance of each pad from the target on the way in [m]; grows with the uncertainty of
  /// the target's size, by 4 mm at most.
  double pad_margin = 0.0025;
  /// Distance between a depth sensor's two eyes, or eye and projector [m]: the largest whose blind
  /// bands beside the edges of things count as seen through, up to the second eye's line of sight
  /// over the edge. 0: missing pixels tell nothing.
  double baseline = 0.09;
  /// Whether space beside the image and at missing pixels counts as free where it lies over space
  /// that was seen to be: what stands there would be seen below. Not if things may hang down.
  bool clear_above = true;
  /// Bounds of the thickness of walls held at their rim, which one view does not show [m].
  double min_wall = 0.002, max_wall = 0.008;
  /// Grasps to return at most.
  int max_grasps = 50;

  /// @throws std::invalid_argument naming the field that is out of range
  void check() const;
};

}  // namespace quadrille
