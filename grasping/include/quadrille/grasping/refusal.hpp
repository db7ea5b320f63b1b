#pragma once

#include <map>
#include <optional>
#include <string_view>

#include "quadrille/detector/export.hpp"

namespace quadrille {

/// Why the planner refused something, in the order of its checks. The last two reasons are limits
/// of the plan.
enum class Refusal {
  kViewpoint,       ///< a detection in a cloud that contradicts its viewpoint
  kNoShape,         ///< a detection that bounds no solid
  kFar,             ///< a detection too far away, or too large, to be mapped with the others
  kSeenFromInside,  ///< a hollow detection whose rim was not seen
  kUnmeasured,      ///< a contact line without points at the rim, or across a poorly known side
  kWidth,           ///< a contact line, or a detection, wider than the hand opens
  kFriction,        ///< a contact line that would slip
  kTwist,           ///< a contact line across a wall that the pads would turn
  kContradicted,    ///< a contact line where free space was seen in place of the surface
  kUnreachable,     ///< an approach direction from behind or below
  kApproach,        ///< an approach direction outside the requested cone
  kReach,           ///< a pose of the hand, or a target, outside what the arm reaches
  kSupport,         ///< a hand that would enter the plane that the target stands on
  kTarget,          ///< a hand that would enter the target itself
  kCollision,       ///< a hand that would enter occupied space or another detection
  kUnknown,         ///< a hand that would enter unobserved space
  kClearance,       ///< a hand that would come nearer to obstacles than requested
  kScore,           ///< a grasp that is less likely to succeed than requested
  kCaller,          ///< a grasp that the caller refused, see GraspQuery::accept
  kSurplus,         ///< a detection beyond the largest number that is planned on
  kDeadline,        ///< a target that was not fully searched before the deadline
};

/// Returns the name used in GraspPlan::rejected, in messages and in JSON: "no_shape", "width", …
QUADRILLE_EXPORT std::string_view to_string(Refusal refusal);

/// Number of refusals by reason.
using RefusalCounts = std::map<Refusal, int>;

/// Returns the reason that refused those that passed most checks; nullopt if nothing was refused.
/// This reason decides, even if another one refused more.
QUADRILLE_EXPORT std::optional<Refusal> furthest(const RefusalCounts& refusals);

/// Returns the reason that refused most, of equals the later check; nullopt if nothing was refused.
/// It tells what the object is like for the hand, where the furthest may be true of a few
/// candidates only.
QUADRILLE_EXPORT std::optional<Refusal> commonest(const RefusalCounts& refusals);

}  // namespace quadrille
