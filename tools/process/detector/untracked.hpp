#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <lcmtypes/quadrille/count_t.hpp>
#include <string>
#include <vector>

#include "process/runtime/camera_poses.hpp"
#include "quadrille/bus/rate_limiter.hpp"

namespace quadrille {

/// The clouds that are not tracked, or not even searched, for want of a pose: counted by reason,
/// and logged at a bounded rate.
class Untracked {
 public:
  /// @param searched  whether clouds without a pose are searched
  explicit Untracked(bool searched) : searched_(searched) {}

  /// @param detail  what is wrong, for the log
  void add(const std::string& channel, std::int64_t cloud_utime, PoseLack lack,
           const std::string& detail);

  std::int64_t total() const { return counts_[0] + counts_[1]; }

  /// One entry for each reason that occurred: "no_pose", "old_pose".
  std::vector<count_t> to_message() const;

 private:
  bool searched_;
  std::array<std::int64_t, 2> counts_{};
  bus::RateLimiter log_{std::chrono::seconds(1)};
};

}  // namespace quadrille
