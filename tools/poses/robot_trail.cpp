#include "poses/robot_trail.hpp"

#include <utility>
#include <variant>

namespace quadrille {

std::optional<bus::Rejection> RobotTrail::add(std::span<const std::byte> bytes) {
  auto decoded = decode_robot_state(bytes);
  if (auto* const refused = std::get_if<bus::Rejection>(&decoded)) return std::move(*refused);
  auto state = std::make_shared<const RobotState>(std::get<RobotState>(std::move(decoded)));
  states_.add(state->utime, bytes.size(), state);
  return std::nullopt;
}

std::shared_ptr<const RobotState> RobotTrail::at(std::int64_t utime) const {
  const auto* const nearest = states_.nearest(utime);
  return nearest == nullptr ? nullptr : *nearest;
}

}  // namespace quadrille
