#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "poses/robot_state.hpp"
#include "poses/timed_values.hpp"
#include "quadrille/bus/rejection.hpp"

namespace quadrille {

/// The shapes of a robot that moves, as its last messages told them.
class RobotTrail {
 public:
  /// Limits of the states, in number, and in bytes of the messages but for the newest. Clouds are
  /// handled before a robot that tells its shapes a hundred times a second has sent so many.
  static constexpr std::size_t kMaxStates = 256, kMaxBytes = std::size_t{64} << 20;

  /// Adds a message of type quadrille.robot_t; returns why it was refused, if it was.
  [[nodiscard]] std::optional<bus::Rejection> add(std::span<const std::byte> bytes);

  /// Returns the state that is nearest to a time [us], or the newest one for a time of 0; null if
  /// there is none.
  std::shared_ptr<const RobotState> at(std::int64_t utime) const;

 private:
  TimedValues<std::shared_ptr<const RobotState>> states_{kMaxStates, kMaxBytes};
};

}  // namespace quadrille
