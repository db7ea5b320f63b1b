#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "contacts/candidates.hpp"
#include "contacts/hold.hpp"
#include "contacts/surface_points.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// Limits for thin walls that the sensor saw from one side only.
struct ThinWalls {
  /// Least and greatest thickness [m]; there are no thin walls if the latter is 0.
  double min = 0.0, max = 0.0;
  /// Whether space was seen to be free at a point in frame C.
  std::function<bool(const Eigen::Vector3d& p_C)> is_free;
};

/// Returns holds on points of which no shape is known. The hand is moved across the points in steps
/// and down to several depths, in each of the hand_directions(). The contacts are the outermost
/// points between the fingers: the two ends of a run of points without a gap for a finger. At least
/// one of the two sides that the pads touch must have been seen. The other one may be hidden, but
/// not behind a surface that faces away from its pad (PadSide::behind), unless this is a thin wall
/// at whose rim space was seen to be free on the hidden side. The most promising come first, in
/// passes of unlike ones, in the same order for the same input.
/// @param own  for each point, nonzero if it belongs to the target, as at least one contact does
/// @param walls  thin walls that may be held at their rim
/// @param max_friction  largest friction coefficient that a hold may need [-]
std::vector<Hold> point_holds(const SurfacePoints& points, const std::vector<char>& own,
                              const Gripper& gripper, const ApproachSpace& space,
                              const ThinWalls& walls, double max_friction);

}  // namespace quadrille
