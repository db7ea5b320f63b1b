#include "view/log/log_frames.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <variant>

#include "quadrille/detector/printable.hpp"

namespace quadrille::view {

LogFrames::LogFrames(const std::string& path, const std::string& channel, double unit,
                     const std::string& robot_channel)
    : path_(path), channel_(channel), unit_(unit) {
  bus::LogReader reader(path);
  RobotTrail robot;
  for (std::int64_t event = 0; const auto found = reader.next(); ++event) {
    if (!robot_channel.empty() && found->channel == robot_channel) robot.add(found->bytes);
    if (!channel.empty() && found->channel != channel) continue;
    const auto stamp = bus::read_stamp(found->bytes);
    if (!stamp || !std::holds_alternative<bus::CloudMessage>(bus::decode_cloud(found->bytes))) {
      continue;
    }
    utimes_.push_back(stamp->utime);
    events_.push_back(event);
    robots_.push_back(robot.at(stamp->utime));
  }
  defect_ = reader.survey().defect;
  if (!utimes_.empty()) return;
  throw std::runtime_error(
      fmt::format("{}: holds no cloud{}; record POINT_CLOUD messages, or name another --channel",
                  path, channel.empty() ? "" : " on " + printable(channel)));
}

std::optional<LogFrame> LogFrames::load(std::size_t number) {
  if (number >= events_.size()) return std::nullopt;
  if (!reader_ || next_event_ > events_[number]) {
    reader_ = std::make_unique<bus::LogReader>(path_);
    next_event_ = 0;
  }
  while (const auto event = reader_->next()) {
    if (next_event_++ < events_[number]) continue;
    auto decoded =
        bus::decode_cloud(event->bytes, bus::kMaxMessageBytes, bus::CloudColours::kKeep, unit_);
    auto* const message = std::get_if<bus::CloudMessage>(&decoded);
    if (message == nullptr) break;
    return LogFrame{{std::move(*message), event->channel, event->utime}, robots_[number]};
  }
  return std::nullopt;
}

}  // namespace quadrille::view
