#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <lcmtypes/quadrille/count_t.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "poses/camera_poses.hpp"
#include "poses/waiting_clouds.hpp"
#include "process/runtime/limited_log.hpp"
#include "process/runtime/node.hpp"
#include "process/runtime/refusals.hpp"
#include "run/rate_limiter.hpp"

namespace quadrille {

/// The source of a camera's poses.
struct PoseSource {
  /// Channel on which poses come; empty if there are none.
  std::string channel;
  /// Pose of all clouds; without it, each cloud has its own, or an unknown one.
  std::optional<Eigen::Isometry3d> fixed;
  /// Longest time between a cloud and each of the two poses around it [s].
  double max_age = 0.0;
  /// Longest time that a cloud waits for the pose after it [s].
  double max_wait = 0.0;
};

/// Gives clouds the poses of their camera. A cloud whose pose is not known yet waits, and the next
/// ones wait behind it, so that clouds are processed in the order in which they came. The caller
/// gives the time, which in a replay is that of the log. Not for two threads at once.
class PosedClouds {
 public:
  /// Called for a cloud once its pose is known, or once it is clear that it has none.
  using Then = std::function<std::optional<Job>(const CameraPose&)>;

  /// @param fate  what happens to clouds with a pose, such as "tracked", for the log
  /// @param max_bytes  memory of the clouds that may wait
  PosedClouds(PoseSource source, std::string fate, std::size_t max_bytes = kMaxBytesWaiting);

  /// Receives a message of the channel of poses; an invalid one is added to the refusals.
  void receive_pose(std::span<const std::byte> bytes, Refusals* refusals);

  /// Adds a cloud taken at this time [us].
  /// @param bytes  memory that it takes while it waits
  /// @return its job, if it need not wait
  std::optional<Job> add(std::int64_t utime, std::size_t bytes, Then then);

  /// Has a function called right after the last waiting cloud of this time.
  /// @return false if no such cloud waits; the function is then not called
  bool follow(std::int64_t utime, Then then);

  /// Returns the jobs of the clouds whose poses are known, or whose waiting time is over.
  /// @param now  time of a clock that never goes back; messages until the next call count as coming
  /// at this time
  std::vector<Job> take_due(Node::Time now);

  /// Number of messages on the channel of poses.
  std::int64_t poses() const { return poses_received_; }
  /// Number of clouds that got no pose.
  std::int64_t poseless() const;
  /// Returns the number of clouds that got no pose by reason: "no_pose", "old_pose", "late_pose",
  /// "jump".
  /// Reasons that did not occur are left out.
  std::vector<count_t> count_poseless() const;
  /// Returns oddities in the poses of a whole log with this many clouds; empty if there are none. A
  /// log without poses is not reported here, but with the other channels.
  std::string find_oddity(std::int64_t clouds) const;
  /// Returns CameraPose::age of the last cloud [ms]; -1 if there was none.
  double last_age_ms() const;

 private:
  /// What is to be done with a cloud.
  using Thens = std::vector<Then>;

  std::vector<Job> finish(const WaitingClouds<Thens>::Posed& due);
  void note(std::int64_t utime, const CameraPose& pose);

  PoseSource source_;
  std::string fate_;
  WaitingClouds<Thens> waiting_;
  Node::Time now_{};
  std::int64_t poses_received_ = 0;
  std::array<std::int64_t, kPoseLackNames.size()> poseless_{};
  std::optional<double> last_age_;
  LimitedLog poseless_log_, far_log_{std::chrono::seconds(10)};
};

}  // namespace quadrille
