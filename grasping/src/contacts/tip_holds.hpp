#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "body/body.hpp"
#include "contacts/candidates.hpp"
#include "contacts/hold.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "space/collision.hpp"

namespace quadrille {

/// Limits of a search for holds by the tips.
struct TipLimits {
  /// The search leaves out holds with the hand more than 5 mm below one of the scene's planes, and
  /// orientations in which the palm collides wherever the tips are.
  const CollisionScene& scene;
  /// Length of the straight approach [m].
  double approach = 0.0;
  /// Largest friction coefficient that a hold may need [-].
  double friction = 0.5;
  /// If set, orientations are left out for which it returns true: it is given the orientation X_CG,
  /// with its origin at that of C, and a box in its axes that holds all origins of G [m].
  std::function<bool(const Eigen::Isometry3d& X_CG, const Eigen::AlignedBox3d& places_G)>
      out_of_reach = {};
  /// If set, the search leaves out holds with more than this distance between the contacts along a
  /// closing direction, and directions for which it is not positive [m].
  std::function<double(const Eigen::Vector3d& closing_C)> max_width = {};
  /// If set, the search ends after half of the orientations, which are spread over all
  /// directions, unless this returns true for one of the holds that they gave.
  std::function<bool(const Hold& hold)> is_promising = {};
};

/// Returns holds by the finger tips wherever they reach: at an end, beside the widest part, or
/// askew. The hand comes down on the body to one of several depths, at its middle or beside it; the
/// contacts lie where the body is widest within the pads' faces, found on a grid of chords. These
/// holds are many and seldom as good as those across the middle of a body, so they are tried where
/// those are blocked. The most promising come first, in passes of unlike ones, in the same order
/// for the same input. Boxes have none.
std::vector<Hold> tip_holds(const Body& body, const Gripper& gripper, const ApproachSpace& space,
                            const TipLimits& limits);

}  // namespace quadrille
