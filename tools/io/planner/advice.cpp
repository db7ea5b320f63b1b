#include "io/planner/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace quadrille {
namespace {

struct Advice {
  Refusal reason;
  std::string_view text;
};

constexpr std::array<Advice, 21> kAdvice = {{
    {Refusal::kViewpoint,
     "the cloud cannot have been seen from its viewpoint; name where the sensor stood "
     "(--viewpoint, --camera-pose)"},
    {Refusal::kNoShape,
     "the quadrics that were found bound no solid; try a view that shows more of the objects"},
    {Refusal::kFar,
     "most lie too far from the viewpoint, or from each other, for one map; set a larger "
     "resolution (under [planner] in --config FILE), or crop the cloud"},
    {Refusal::kSeenFromInside,
     "only the insides of hollow things were seen; try a view that shows their rims"},
    {Refusal::kUnmeasured, "the rims were not measured; try a closer view, or one from higher up"},
    {Refusal::kWidth,
     "most are wider than the gripper's opening, or thinner than it closes; try another gripper "
     "(--gripper)"},
    {Refusal::kFriction,
     "most would slip; if the pads grip better than assumed, set friction (under [planner] in "
     "--config FILE)"},
    {Refusal::kTwist,
     "most would twist the walls that they hold; try a gripper with narrower pads (--gripper)"},
    {Refusal::kContradicted,
     "the camera saw through most of the surfaces to be touched, so the fits are poor there; try "
     "a closer view"},
    {Refusal::kUnreachable,
     "most can only be approached from behind or below; try a view from the side on which the "
     "gripper is to be"},
    {Refusal::kSupport,
     "most candidates end in the plane that the object stands on; try a gripper with slimmer "
     "fingers (--gripper), or raise the object"},
    {Refusal::kTarget,
     "most candidates touch the object before they close; try a gripper that opens wider or has "
     "longer fingers (--gripper)"},
    {Refusal::kCollision,
     "most candidates end in other things; clear the space around, try a slimmer gripper "
     "(--gripper), or a shorter approach (under [planner] in --config FILE)"},
    {Refusal::kApproach,
     "most approaches lie outside the cone that was asked for; allow a wider one (--approach)"},
    {Refusal::kReach,
     "the arm does not reach most of the poses; move its base or the objects, or name what it "
     "reaches (--reach)"},
    {Refusal::kClearance,
     "most candidates come nearer to other things than was asked for; ask for less clearance "
     "(--min-clearance)"},
    {Refusal::kScore,
     "most candidates are too likely to fail; allow a lower score (--min-score), or try a closer "
     "view"},
    {Refusal::kCaller, "the program that asked refused most grasps itself"},
    {Refusal::kSurplus,
     "there are more quadrics than are planned on; set max_detections (under [planner] in --config "
     "FILE), or crop the cloud"},
    {Refusal::kDeadline,
     "the deadline passed before a grasp was found; allow more time (--deadline-ms)"},
    {Refusal::kUnknown, "most candidates end in space the camera has not seen; "},
}};

std::string_view cure_of_unknown(UnknownPolicy unknown) {
  return unknown == UnknownPolicy::kObstacle
             ? "let the gripper into the object's own shadow (--unknown target-shadow), or add "
               "views"
             : "take unknown space as free if nothing else can be there (--unknown free), or add "
               "views";
}

}  // namespace

std::string advise(std::string_view reason, UnknownPolicy unknown) {
  for (const Advice& advice : kAdvice) {
    if (to_string(advice.reason) != reason) continue;
    std::string line(advice.text);
    if (advice.reason == Refusal::kUnknown) line += cure_of_unknown(unknown);
    return line;
  }
  return "";
}

std::string explain_no_grasp(const TargetOutcome& outcome, UnknownPolicy unknown) {
  const std::optional<Refusal> why = furthest(outcome.refusals);
  if (!why) return "no way to hold it was found; try a closer view";
  int all = 0;
  for (const auto& [reason, count] : outcome.refusals) all += count;
  return fmt::format("{} ({} of {} candidates, those that got furthest): {}", to_string(*why),
                     outcome.refusals.at(*why), all, advise(to_string(*why), unknown));
}

}  // namespace quadrille
