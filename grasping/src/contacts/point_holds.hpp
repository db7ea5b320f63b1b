#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "contacts/candidates.hpp"
#include "contacts/hold.hpp"
#include "contacts/slice_holds.hpp"
#include "contacts/surface_points.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// Orientations of the hand are tried in so many rounds: every third one from the first on, then
/// every third one from the second on, and so forth, so that each round has all kinds of them.
inline constexpr std::size_t kHoldRounds = 3;

/// Tells whether it is worth going on after some rounds, from the holds that these found.
using GoesOn = std::function<bool(int rounds, std::span<const Hold> found)>;

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
/// @param goes_on  if set, the search ends after a round for which this returns false
std::vector<Hold> point_holds(const SurfacePoints& points, const std::vector<char>& own,
                              const Gripper& gripper, const ApproachSpace& space,
                              const ThinWalls& walls, double max_friction,
                              const GoesOn& goes_on = {});

}  // namespace quadrille
