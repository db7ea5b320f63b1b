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
  std::string_view what;
  /// What may help; empty if it depends on other settings, or nothing does.
  std::string_view cure;
  /// Whether nothing else helps, so that it is worth saying before it was tried.
  bool is_sure = false;
};

constexpr std::array<Advice, 21> kAdvice = {{
    {Refusal::kViewpoint, "the cloud cannot have been seen from its viewpoint",
     "name where the sensor stood (--viewpoint, --camera-pose)", true},
    {Refusal::kNoShape, "what was found of it bounds no solid",
     "try a view that shows more of the object"},
    {Refusal::kFar, "it lies too far from the viewpoint, or from other things, for one map",
     "set a larger resolution (under [planner] in --config FILE), or crop the cloud", true},
    {Refusal::kSeenFromInside, "only its inside was seen", "try a view that shows its rim"},
    {Refusal::kUnmeasured, "its rim or side was not measured",
     "try a closer view, or one from higher up"},
    {Refusal::kWidth, "it is wider than the gripper opens, or thinner than it closes",
     "try another gripper (--gripper)"},
    {Refusal::kFriction, "the pads would slip",
     "if they grip better than assumed, set friction (under [planner] in --config FILE)"},
    {Refusal::kTwist, "the pads would twist the wall that they hold",
     "try a gripper with narrower pads (--gripper)"},
    {Refusal::kContradicted,
     "the camera saw through the surface to be touched, so the fit is poor there",
     "try a closer view"},
    {Refusal::kUnreachable, "it can only be approached from behind or below",
     "try a view from the side on which the gripper is to be"},
    {Refusal::kApproach, "the approach lies outside the cone that was asked for",
     "allow a wider one (--approach)"},
    {Refusal::kReach, "the arm does not reach it",
     "move its base or the object, or name what it reaches (--reach)"},
    {Refusal::kSupport, "the hand would enter the plane that the object stands on",
     "try a gripper with slimmer fingers (--gripper), or raise the object"},
    {Refusal::kTarget, "the hand would touch the object before it closes",
     "try a gripper that opens wider or has longer fingers (--gripper)"},
    {Refusal::kCollision, "the hand would hit something",
     "add a view if nothing stands there but the object itself, clear the space around, try a "
     "slimmer gripper (--gripper), or a shorter approach (under [planner] in --config FILE)"},
    {Refusal::kUnknown, "the hand would enter space the camera has not seen", ""},
    {Refusal::kClearance, "the hand would come nearer to other things than was asked for",
     "ask for less clearance (--min-clearance)"},
    {Refusal::kScore, "the grasp is too likely to fail",
     "allow a lower score (--min-score), or try a closer view"},
    {Refusal::kCaller, "the program that asked refused the grasp itself", ""},
    {Refusal::kSurplus, "there are more quadrics than are planned on",
     "set max_detections (under [planner] in --config FILE), or crop the cloud", true},
    {Refusal::kDeadline, "the deadline passed before a grasp was found",
     "allow more time (--deadline-ms)"},
}};

std::string_view cure_of_unknown(UnknownPolicy unknown) {
  return unknown == UnknownPolicy::kObstacle
             ? "let the gripper into the object's own shadow (--unknown target-shadow), or add "
               "views"
             : "take unknown space as free if nothing else can be there (--unknown free), or add "
               "views";
}

const Advice* find_advice(std::string_view reason) {
  for (const Advice& advice : kAdvice) {
    if (to_string(advice.reason) == reason) return &advice;
  }
  return nullptr;
}

std::string join(std::string_view what, std::string_view cure) {
  return cure.empty() ? std::string(what) : fmt::format("{}; {}", what, cure);
}

}  // namespace

std::string advise(std::string_view reason, UnknownPolicy unknown) {
  const Advice* const advice = find_advice(reason);
  if (advice == nullptr) return "";
  return join(advice->what,
              advice->reason == Refusal::kUnknown ? cure_of_unknown(unknown) : advice->cure);
}

std::string explain_no_grasp(const TargetOutcome& outcome) {
  const std::optional<Refusal> why = furthest(outcome.refusals);
  if (!why) return "no way to hold it was found";
  int all = 0;
  for (const auto& [reason, count] : outcome.refusals) all += count;
  const int refused = outcome.refusals.at(*why);
  const std::string which =
      refused == all ? fmt::format("all {} candidates", all)
                     : fmt::format("{} of {} candidates, which got furthest", refused, all);
  const Advice* const advice = find_advice(to_string(*why));
  if (advice == nullptr) return fmt::format("{} ({})", to_string(*why), which);
  return fmt::format("{} ({}): {}", to_string(*why), which,
                     join(advice->what, advice->is_sure ? advice->cure : ""));
}

}  // namespace quadrille
