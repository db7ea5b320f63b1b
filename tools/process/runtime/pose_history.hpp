#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "quadrille/bus/pose_message.hpp"

namespace quadrille {

/// The last poses of a camera.
class PoseHistory {
 public:
  /// @param most  poses to keep, at least 1
  explicit PoseHistory(std::size_t most = 4096) : max_(most) {}

  /// Adds a pose. One that is older than the last means that a log has been started again: all
  /// others are forgotten.
  void add(const bus::PoseMessage& pose);

  /// The newest pose that is not newer than that time; nullopt if there is none. What is not known
  /// yet has no part in it, so that a replay gives what was given live.
  std::optional<bus::PoseMessage> at(std::int64_t utime) const;

  bool empty() const { return poses_.empty(); }

 private:
  std::size_t max_;
  std::deque<bus::PoseMessage> poses_;
};

}  // namespace quadrille
