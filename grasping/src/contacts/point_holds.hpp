#pragma once

#include <vector>

#include "contacts/candidates.hpp"
#include "contacts/hold.hpp"
#include "contacts/surface_points.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// Returns holds on points of which no shape is known. The hand is moved across the points in steps
/// and down to several depths, in each of the hand_directions(). The contacts are the outermost
/// points between the fingers: the two ends of a run of points without a gap for a finger. At least
/// one of the two sides that the pads touch must have been seen; see PadSide for how the other one
/// is judged. The most promising come first, in passes of unlike ones, in the same order for the
/// same input.
/// @param own  for each point, nonzero if it belongs to the target, as at least one contact does
/// @param max_friction  largest friction coefficient that a hold may need [-]
std::vector<Hold> point_holds(const SurfacePoints& points, const std::vector<char>& own,
                              const Gripper& gripper, const ApproachSpace& space,
                              double max_friction);

}  // namespace quadrille
