#include "quadrille/grasping/refusal.hpp"

#include <algorithm>

namespace quadrille {

std::string_view to_string(Refusal refusal) {
  switch (refusal) {
    case Refusal::kViewpoint:
      return "viewpoint";
    case Refusal::kNoShape:
      return "no_shape";
    case Refusal::kFar:
      return "far";
    case Refusal::kSeenFromInside:
      return "seen_from_inside";
    case Refusal::kUnmeasured:
      return "unmeasured";
    case Refusal::kWidth:
      return "width";
    case Refusal::kFriction:
      return "friction";
    case Refusal::kTwist:
      return "twist";
    case Refusal::kContradicted:
      return "contradicted";
    case Refusal::kUnreachable:
      return "unreachable";
    case Refusal::kApproach:
      return "approach";
    case Refusal::kReach:
      return "reach";
    case Refusal::kSupport:
      return "support";
    case Refusal::kTarget:
      return "target";
    case Refusal::kCollision:
      return "collision";
    case Refusal::kUnknown:
      return "unknown";
    case Refusal::kClearance:
      return "clearance";
    case Refusal::kScore:
      return "score";
    case Refusal::kCaller:
      return "caller";
    case Refusal::kSurplus:
      return "surplus";
    case Refusal::kDeadline:
      break;
  }
  return "deadline";
}

std::optional<Refusal> furthest(const RefusalCounts& refusals) {
  if (refusals.empty()) return std::nullopt;
  return refusals.rbegin()->first;
}

std::optional<Refusal> commonest(const RefusalCounts& refusals) {
  if (refusals.empty()) return std::nullopt;
  return std::max_element(refusals.rbegin(), refusals.rend(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

}  // namespace quadrille
