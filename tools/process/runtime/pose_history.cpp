#include "process/runtime/pose_history.hpp"

#include <algorithm>

namespace quadrille {

void PoseHistory::add(const bus::PoseMessage& pose) {
  if (!poses_.empty() && pose.utime < poses_.back().utime) poses_.clear();
  poses_.push_back(pose);
  if (poses_.size() > max_) poses_.pop_front();
}

std::optional<bus::PoseMessage> PoseHistory::at(std::int64_t utime) const {
  const auto later =
      std::upper_bound(poses_.begin(), poses_.end(), utime,
                       [](std::int64_t time, const auto& pose) { return time < pose.utime; });
  if (later == poses_.begin()) return std::nullopt;
  return *std::prev(later);
}

}  // namespace quadrille
