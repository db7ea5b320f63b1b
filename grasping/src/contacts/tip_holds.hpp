#pragma once

#include <Eigen/Core>
#include <vector>

#include "body/body.hpp"
#include "contacts/candidates.hpp"
#include "contacts/contact_line.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "space/collision.hpp"

namespace quadrille {

/// Contacts that a hand finds from one place, and the way it comes.
struct TipHold {
  /// Its centre is the origin of the grasp frame.
  ContactLine line;
  Eigen::Vector3d approach_C;
  /// The friction coefficient that it needs; see PadMeeting [-].
  double friction;
};

/// What bounds a search for holds by the tips.
struct TipLimits {
  /// Holds with the hand more than 5 mm below one of its planes are left out, and orientations in
  /// which the palm runs into something wherever the tips are.
  const CollisionScene& scene;
  /// Length of the straight approach [m].
  double approach = 0.0;
  /// Largest friction coefficient that a hold may need [-].
  double friction = 0.5;
};

/// Holds by the tips, wherever these reach: at an end, beside the widest part, askew. Each is what
/// two pads meet that come down on the body to one of several depths, at its middle or beside it:
/// where the body is widest within their faces, found on a grid of chords. They are many, and
/// seldom as good as those across the middle of a body: a search for where these are blocked. The
/// most promising come first, in passes of unlike ones; always the same order for the same input.
/// None for boxes.
std::vector<TipHold> tip_holds(const Body& body, const Gripper& gripper, const ApproachSpace& space,
                               const TipLimits& limits);

}  // namespace quadrille
