#pragma once

#include <optional>
#include <string>

#include "quadrille/bus/rejection.hpp"

namespace quadrille::logs {

/// Messages on the robot's own shapes in a log that were refused.
struct RobotRefusals {
  int count = 0;
  std::string why_first;

  /// Counts a message that was refused, if it was.
  void add(const std::optional<bus::Rejection>& refused);
  /// Returns a warning; nullopt if none was refused.
  std::optional<std::string> warning(const std::string& channel) const;
};

}  // namespace quadrille::logs
