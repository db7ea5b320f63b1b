#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace quadrille::view {

/// The channels of what is shown, and of what is asked.
struct LiveChannels {
  std::string cloud = "POINT_CLOUD", quadrics = "QUADRICS", boxes = "BOXES", grasps = "GRASPS",
              occupancy = "OCCUPANCY", detector_status = "QUADRILLE_DETECTOR_STATUS",
              planner_status = "QUADRILLE_PLANNER_STATUS", requests = "GRASP_REQUEST";
};

/// The bytes of a message that several may hold; null for none.
using Bytes = std::shared_ptr<const std::vector<std::byte>>;

/// The newest message of each kind, and the last few clouds, as quadrics come later than theirs.
struct LatestMessages {
  std::deque<Bytes> clouds;
  /// Those before the newest, while its boxes have not come.
  Bytes quadrics_before;
  Bytes quadrics, boxes, grasps, occupancy, detector_status, planner_status;
};

/// Keeps what comes from the bus until somebody looks at it. Taking a message never waits for those
/// who look, and clouds are kept only while somebody does.
class MessageKeeper {
 public:
  /// Clouds that are kept at most, and their bytes but for the newest.
  static constexpr std::size_t kMaxClouds = 8, kMaxCloudBytes = std::size_t{64} << 20;

  explicit MessageKeeper(LiveChannels channels) : channels_(std::move(channels)) {}

  /// Takes one message; those of other channels are passed over, and so are answers to requests
  /// of others while the planner plans for all objects by itself.
  void take(const std::string& channel, std::span<const std::byte> bytes);

  /// Somebody looks, for the next few seconds at least.
  void watch();
  /// Waits for something that a new scene can be made of; false if nothing came, or nobody looks.
  bool wait(std::chrono::milliseconds timeout);
  /// What there is; the messages themselves are not copied.
  LatestMessages latest() const;

  const LiveChannels& channels() const { return channels_; }

 private:
  using Clock = std::chrono::steady_clock;

  void keep_cloud(Bytes bytes);

  LiveChannels channels_;
  mutable std::mutex mutex_;
  std::condition_variable news_;
  LatestMessages latest_;
  std::size_t cloud_bytes_ = 0;
  bool has_news_ = false;
  Clock::time_point watched_until_{}, quadrics_came_{}, boxes_came_{}, plan_came_{};
};

}  // namespace quadrille::view
