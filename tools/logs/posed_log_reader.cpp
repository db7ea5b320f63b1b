#include "logs/posed_log_reader.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "quadrille/bus/pose_message.hpp"

namespace quadrille::logs {

PosedLogReader::PosedLogReader(const std::string& path, const std::string& channel,
                               std::string pose_channel, double max_age, double max_wait,
                               double unit, std::string robot_channel)
    : pose_channel_(std::move(pose_channel)),
      robot_channel_(std::move(robot_channel)),
      waiting_(max_age, pose_channel_.empty() ? 0.0 : max_wait),
      clouds_(path, channel, unit, [this](const bus::LogReader::Event& event) { take(event); }) {}

std::optional<PosedCloud> PosedLogReader::next() {
  for (bool is_end = false; ready_.empty() && !is_end;) {
    // Poses that come by settle clouds too.
    std::optional<LoggedCloud> cloud = clouds_.next();
    is_end = !cloud;
    if (cloud) {
      const std::int64_t utime = cloud->message.utime;
      const std::size_t bytes = memory_of(cloud->message.cloud);
      waiting_.add(utime, bytes, now_, *std::move(cloud));
    }
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
  if (!robot_channel_.empty() && event.channel == robot_channel_) {
    robot_refusals_.add(robot_.add(event.bytes));
  }
  if (event.channel != pose_channel_) return;
  const auto decoded = bus::decode_pose(event.bytes);
  if (const auto* const pose = std::get_if<bus::PoseMessage>(&decoded)) waiting_.add(*pose);
  settle();
}

/// Settles the clouds whose poses are known, or whose waiting time is over, in their order.
void PosedLogReader::settle(bool is_end) {
  while (auto due = waiting_.take_due(now_, is_end)) {
    auto robot = robot_.at(due->cloud.message.utime);
    ready_.push_back({std::move(due->cloud), std::move(due->pose), std::move(robot)});
  }
}

}  // namespace quadrille::logs
