#pragma once

#include <cstddef>
#include <cstdint>
#include <lcmtypes/quadrille/robot_t.hpp>
#include <memory>
#include <span>

#include "poses/timed_values.hpp"

namespace quadrille::view {

/// The last messages about the shapes of a robot that moves.
class RobotTrail {
 public:
  /// Limits of the number of messages, and of their bytes, not counting the newest.
  static constexpr std::size_t kMaxMessages = 128, kMaxBytes = std::size_t{4} << 20;

  /// Adds a message of type quadrille.robot_t; a damaged one is left out.
  void add(std::span<const std::byte> bytes);

  /// Returns the message that is nearest to a time [us], or the newest one for a time of 0; null if
  /// there is none.
  std::shared_ptr<const robot_t> at(std::int64_t utime) const;

 private:
  TimedValues<std::shared_ptr<const robot_t>> kept_{kMaxMessages, kMaxBytes};
};

}  // namespace quadrille::view
