#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "poses/camera_poses.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Limits of the clouds that wait for their poses, in number and in memory [byte]. If there are
/// more, the first gets no pose; the newest may always wait.
inline constexpr std::size_t kMaxCloudsWaiting = 32;
inline constexpr std::size_t kMaxBytesWaiting = std::size_t{256} << 20;

/// Returns the memory that the points of a cloud take [byte].
inline std::size_t memory_of(const PointCloud& cloud) {
  return cloud.points.capacity() * sizeof(Eigen::Vector3f);
}

/// Clouds of one camera that wait for its poses. A cloud whose pose is not known yet waits, and the
/// next ones wait behind it, so that all are handled in the order in which they came.
template <class Cloud>
class WaitingClouds {
 public:
  struct Posed {
    /// When the cloud was taken [us].
    std::int64_t utime = 0;
    Cloud cloud;
    CameraPose pose;
  };

  /// @param max_age, max_wait  as CameraPoses has them [s]
  /// @param max_bytes  memory of the clouds that may wait
  WaitingClouds(double max_age, double max_wait, std::size_t max_bytes = kMaxBytesWaiting)
      : poses_(max_age, max_wait), max_wait_(std::round(1e6 * max_wait)), max_bytes_(max_bytes) {}

  void add(const bus::PoseMessage& pose) { poses_.add(pose); }

  /// Adds a cloud.
  /// @param now  when it came, by a clock that never goes back [us]
  void add(std::int64_t utime, std::size_t bytes, std::int64_t now, Cloud cloud) {
    waiting_.push_back({utime, bytes, now, std::move(cloud)});
    bytes_ += bytes;
  }

  bool empty() const { return waiting_.empty(); }

  /// Returns the last cloud of this time; null if there is none.
  Cloud* find(std::int64_t utime) {
    const auto last = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                   [&](const Waiting& w) { return w.utime == utime; });
    return last == waiting_.rend() ? nullptr : &last->cloud;
  }

  /// Returns the first cloud if its pose is known, or it has waited long enough; then the pose says
  /// why it is not known.
  /// @param is_end  true if no more poses will come
  std::optional<Posed> take_due(std::int64_t now, bool is_end = false) {
    if (waiting_.empty()) return std::nullopt;
    Waiting& first = waiting_.front();
    CameraPose pose = poses_.at(first.utime);
    if (!pose.X_WK) {
      const double waited = static_cast<double>(now) - static_cast<double>(first.since);
      // No later pose makes up for one that is wrong.
      const bool may_come = !is_end && pose.lack != PoseLack::kJump;
      if (may_come && !is_crowded() && max_wait_ > 0.0 && waited <= max_wait_) return std::nullopt;
      pose.detail = poses_.explain(first.utime, pose) + (is_crowded() ? describe_crowd() : "");
    }
    Posed posed{first.utime, std::move(first.cloud), std::move(pose)};
    bytes_ -= first.bytes;
    waiting_.pop_front();
    return posed;
  }

 private:
  struct Waiting {
    std::int64_t utime = 0;
    std::size_t bytes = 0;
    std::int64_t since = 0;
    Cloud cloud;
  };

  bool is_full() const { return waiting_.size() > 1 && bytes_ > max_bytes_; }
  bool is_crowded() const { return waiting_.size() > kMaxCloudsWaiting || is_full(); }
  std::string describe_crowd() const {
    return is_full() ? "; more than " + std::to_string(max_bytes_ >> 20) + " MiB of clouds wait"
                     : "; more than " + std::to_string(kMaxCloudsWaiting) + " clouds wait";
  }

  CameraPoses poses_;
  /// Longest time that a cloud waits [us].
  double max_wait_;
  std::size_t max_bytes_, bytes_ = 0;
  std::deque<Waiting> waiting_;
};

}  // namespace quadrille
