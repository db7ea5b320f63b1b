#include "logs/robot_refusals.hpp"

#include <fmt/format.h>

#include "quadrille/detector/printable.hpp"

namespace quadrille::logs {

void RobotRefusals::add(const std::optional<bus::Rejection>& refused) {
  if (refused && count++ == 0) why_first = refused->detail;
}

std::optional<std::string> RobotRefusals::warning(const std::string& channel) const {
  if (count == 0) return std::nullopt;
  return fmt::format(
      "refused {} message{} on {}, so points of the robot may be taken for things; the first: {}",
      count, count == 1 ? "" : "s", printable(channel), why_first);
}

}  // namespace quadrille::logs
