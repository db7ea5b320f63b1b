#pragma once

#include <map>
#include <string_view>

#include "quadrille/detector/export.hpp"

namespace quadrille {

/// Why the planner refused something.
enum class Refusal {
  kViewpoint,       ///< a detection in a cloud that contradicts its viewpoint
  kNoShape,         ///< a detection that bounds no solid
  kFar,             ///< a detection too far off, or too large, to be mapped with the others
  kSeenFromInside,  ///< a hollow detection whose rim was not seen
  kUnmeasured,      ///< a contact line without points at the rim, or across a side not known well
  kWidth,           ///< a contact line, or a detection, wider than the hand opens
  kFriction,        ///< a contact line that would slip
  kTwist,           ///< a contact line across a wall that the pads would turn
  kContradicted,    ///< a contact line where free space was seen instead of the surface
  kUnreachable,     ///< an approach direction from behind or below
  kApproach,        ///< an approach direction outside the cone that was asked for
  kSupport,         ///< a hand that would enter the plane that the target stands on
  kTarget,          ///< a hand that would enter the target itself
  kCollision,       ///< a hand that would enter occupied space or another detection
  kUnknown,         ///< a hand that would enter unobserved space
  kClearance,       ///< a hand that would come nearer to things than was asked for
  kSurplus,         ///< a detection beyond the number that is planned on
  kDeadline,        ///< a target that was not tried to its end before the deadline
};

/// Its name, as in GraspPlan::rejected, in messages and in JSON: "no_shape", "width", …
QUADRILLE_EXPORT std::string_view to_string(Refusal refusal);

/// How often something was refused, by reason.
using RefusalCounts = std::map<Refusal, int>;

}  // namespace quadrille
