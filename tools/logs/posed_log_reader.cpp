#include "logs/posed_log_reader.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "quadrille/bus/pose_message.hpp"

namespace quadrille::logs {

PosedLogReader::PosedLogReader(const std::string& path, const std::string& channel,
                               std::string pose_channel, double max_age, double max_wait)
    : pose_channel_(std::move(pose_channel)),
      max_wait_(max_wait),
      poses_(max_age, max_wait),
      clouds_(path, channel, [this](const bus::LogReader::Event& event) { take(event); }) {}

std::optional<PosedCloud> PosedLogReader::next() {
  for (bool is_end = false; ready_.empty() && !is_end;) {
    // Poses that come by settle clouds too.
    std::optional<LoggedCloud> cloud = clouds_.next();
    is_end = !cloud;
    if (cloud) waiting_.push_back({*std::move(cloud), now_});
    settle(is_end);
  }
  if (ready_.empty()) return std::nullopt;
  PosedCloud cloud = std::move(ready_.front());
  ready_.pop_front();
  return cloud;
}

/// Takes note of an event of the log.
void PosedLogReader::take(const bus::LogReader::Event& event) {
  now_ = std::max(now_, event.utime);
  settle();
  if (event.channel != pose_channel_) return;
  const auto decoded = bus::decode_pose(event.bytes);
  if (const auto* const pose = std::get_if<bus::PoseMessage>(&decoded)) poses_.add(*pose);
  settle();
}

/// Settles the clouds whose poses are known, or whose waiting time is over, in their order.
void PosedLogReader::settle(bool is_end) {
  while (!waiting_.empty()) {
    auto& [cloud, since] = waiting_.front();
    CameraPose pose = poses_.at(cloud.message.utime);
    const bool is_late = pose_channel_.empty() || max_wait_ == 0.0 ||
                         seconds_between(since, now_) > max_wait_ ||
                         waiting_.size() > kMaxCloudsWaiting;
    if (!pose.X_WK && !is_late && !is_end) return;
    if (!pose.X_WK) pose.detail = poses_.explain(cloud.message.utime, pose);
    ready_.push_back({std::move(cloud), std::move(pose)});
    waiting_.pop_front();
  }
}

}  // namespace quadrille::logs
