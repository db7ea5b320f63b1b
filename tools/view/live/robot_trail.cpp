#include "view/live/robot_trail.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "poses/pose_history.hpp"
#include "quadrille/bus/scene_messages.hpp"

namespace quadrille::view {

void RobotTrail::add(std::span<const std::byte> bytes) {
  auto decoded = bus::decode_robot(bytes);
  auto* const robot = std::get_if<robot_t>(&decoded);
  if (robot == nullptr) return;
  // A time of 0 means that the shapes are always so; a clock that was set back ends the history.
  const std::int64_t utime = robot->utime;
  const bool begins =
      utime == 0 ||
      (!kept_.empty() && (kept_.back().message->utime == 0 || utime < kept_.back().message->utime));
  if (begins) {
    kept_.clear();
    bytes_ = 0;
  }
  kept_.push_back({bytes.size(), std::make_shared<const robot_t>(std::move(*robot))});
  bytes_ += bytes.size();
  while (kept_.size() > kMaxMessages || (kept_.size() > 1 && bytes_ > kMaxBytes)) {
    bytes_ -= kept_.front().size;
    kept_.pop_front();
  }
}

std::shared_ptr<const robot_t> RobotTrail::at(std::int64_t utime) const {
  if (kept_.empty()) return nullptr;
  if (utime == 0) return kept_.back().message;
  const auto distance = [&](const Kept& kept) {
    return std::abs(seconds_between(kept.message->utime, utime));
  };
  return std::min_element(kept_.begin(), kept_.end(),
                          [&](const Kept& a, const Kept& b) { return distance(a) < distance(b); })
      ->message;
}

}  // namespace quadrille::view
