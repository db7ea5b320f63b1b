#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "quadrille/grasping/plan.hpp"

namespace quadrille::io {

constexpr std::array<UnknownPolicy, 3> all_unknown_policies() {
  return {UnknownPolicy::kObstacle, UnknownPolicy::kTargetShadow, UnknownPolicy::kFree};
}

/// "obstacle", "target-shadow" or "free".
std::string_view to_string(UnknownPolicy policy);

/// The policy of a name; nullopt if there is none of that name.
std::optional<UnknownPolicy> unknown_policy_from_string(std::string_view name);

}  // namespace quadrille::io
