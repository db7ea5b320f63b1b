#include "view/live/robot_trail.hpp"

#include <utility>
#include <variant>

#include "quadrille/bus/scene_messages.hpp"

namespace quadrille::view {

void RobotTrail::add(std::span<const std::byte> bytes) {
  auto decoded = bus::decode_robot(bytes);
  auto* const robot = std::get_if<robot_t>(&decoded);
  if (robot == nullptr) return;
  const std::int64_t utime = robot->utime;
  kept_.add(utime, bytes.size(), std::make_shared<const robot_t>(std::move(*robot)));
}

std::shared_ptr<const robot_t> RobotTrail::at(std::int64_t utime) const {
  const auto* const nearest = kept_.nearest(utime);
  return nearest ? *nearest : nullptr;
}

}  // namespace quadrille::view
