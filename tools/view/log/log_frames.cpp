#include "view/log/log_frames.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <variant>

#include "quadrille/detector/printable.hpp"

namespace quadrille::view {

LogFrames::LogFrames(const std::string& path, const std::string& channel, double unit,
                     const std::string& robot_channel)
    : path_(path), channel_(channel), robot_channel_(robot_channel), unit_(unit) {
  bus::LogReader reader(path);
  for (std::int64_t event = 0; const auto found = reader.next(); ++event) {
    if (!robot_channel.empty() && found->channel == robot_channel) {
      const auto decoded = decode_robot_state(found->bytes);
      if (const auto* const refused = std::get_if<bus::Rejection>(&decoded)) {
        robot_refusals_.add(*refused);
      }
    }
    if (!channel.empty() && found->channel != channel) continue;
    const auto stamp = bus::read_stamp(found->bytes);
    if (!stamp || !std::holds_alternative<bus::CloudMessage>(bus::decode_cloud(found->bytes))) {
      continue;
    }
    utimes_.push_back(stamp->utime);
    events_.push_back(event);
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
    robot_ = {};
  }
  while (const auto event = reader_->next()) {
    if (!robot_channel_.empty() && event->channel == robot_channel_) {
      // The constructor counted what is refused.
      static_cast<void>(robot_.add(event->bytes));
    }
    if (next_event_++ < events_[number]) continue;
    auto decoded =
        bus::decode_cloud(event->bytes, bus::kMaxMessageBytes, bus::CloudColours::kKeep, unit_);
    auto* const message = std::get_if<bus::CloudMessage>(&decoded);
    if (message == nullptr) break;
    auto robot = robot_.at(message->utime);
    return LogFrame{number, {std::move(*message), event->channel, event->utime}, std::move(robot)};
  }
  return std::nullopt;
}

}  // namespace quadrille::view
