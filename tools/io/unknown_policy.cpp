#include "io/unknown_policy.hpp"

namespace quadrille::io {

std::string_view to_string(UnknownPolicy policy) {
  switch (policy) {
    case UnknownPolicy::kObstacle:
      return "obstacle";
    case UnknownPolicy::kTargetShadow:
      return "target-shadow";
    case UnknownPolicy::kFree:
      return "free";
  }
  return "obstacle";
}

std::optional<UnknownPolicy> unknown_policy_from_string(std::string_view name) {
  for (const UnknownPolicy policy : all_unknown_policies()) {
    if (name == to_string(policy)) return policy;
  }
  return std::nullopt;
}

}  // namespace quadrille::io
