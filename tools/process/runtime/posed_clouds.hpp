#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <lcmtypes/quadrille/count_t.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "process/runtime/camera_poses.hpp"
#include "process/runtime/node.hpp"
#include "process/runtime/refusals.hpp"
#include "quadrille/bus/rate_limiter.hpp"

namespace quadrille {

/// Where the poses of a camera come from.
struct PoseSource {
  /// On which they come; empty if none do.
  std::string channel;
  /// The pose of all clouds; none: that of each cloud comes, or is not known.
  std::optional<Eigen::Isometry3d> fixed;
  /// Longest time between a cloud and each of the two poses about it [s].
  double max_age = 0.0;
  /// How long a cloud waits for the pose after it [s].
  double max_wait = 0.0;
};

/// Gives clouds the poses of their camera. A cloud whose pose is not known yet waits; the next ones
/// wait behind it, so that clouds are done in the order in which they came. The caller tells the
/// time, which in a replay is that of the log. Not for two threads at once.
class PosedClouds {
 public:
  /// What is done with a cloud, once it is known which pose it has, or that it has none.
  using Then = std::function<std::optional<Job>(const CameraPose&)>;

  /// Clouds that wait at most; if one more comes the first gets no pose.
  static constexpr std::size_t kMaxWaiting = 32;

  /// @param fate  of clouds with a pose, such as "tracked", for the log
  PosedClouds(PoseSource source, std::string fate);

  /// Takes a message of the channel of poses; one that is none is added to the refusals.
  void receive_pose(std::span<const std::byte> bytes, Refusals* refusals);

  /// Takes a cloud of that time [us].
  /// @return what came of it, if it need not wait
  std::optional<Job> add(std::int64_t utime, Then then);

  /// Has something done right after the last cloud of that time that waits.
  /// @return false if none does: then nothing is done
  bool follow(std::int64_t utime, Then then);

  /// What came of the clouds whose poses are known, or whose time is over.
  /// @param now  by a clock that never goes back; what comes until the next call comes at this time
  std::vector<Job> take_due(Node::Time now);

  /// Messages on the channel of poses.
  std::int64_t poses() const { return poses_received_; }
  /// Clouds that got no pose.
  std::int64_t poseless() const;
  /// The same by reason, one entry for each that occurred: "no_pose", "old_pose", "late_pose".
  std::vector<count_t> count_poseless() const;
  /// What is odd about the poses of all that a log held, of so many clouds; empty if nothing is.
  /// That none came is told with the other channels.
  std::string find_oddity(std::int64_t clouds) const;
  /// CameraPose::age of the last cloud [ms]; -1 if there was none.
  double last_age_ms() const;

 private:
  struct Waiting {
    std::int64_t utime = 0;
    /// When it came.
    Node::Time since{};
    std::vector<Then> thens;
  };

  bool is_due(const Waiting& cloud, const CameraPose& pose) const;
  bool is_crowded() const { return waiting_.size() > kMaxWaiting; }
  void explain(const Waiting& cloud, CameraPose* none) const;
  void note(std::int64_t utime, const CameraPose& pose);

  PoseSource source_;
  std::string fate_;
  Node::Time max_wait_;
  CameraPoses poses_;
  std::deque<Waiting> waiting_;
  Node::Time now_{};
  std::int64_t poses_received_ = 0;
  std::array<std::int64_t, 3> poseless_{};
  std::optional<double> last_age_;
  bus::RateLimiter poseless_log_{std::chrono::seconds(1)}, far_log_{std::chrono::seconds(10)};
};

}  // namespace quadrille
