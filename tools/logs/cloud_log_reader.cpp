#include "logs/cloud_log_reader.hpp"

#include <utility>

namespace quadrille::logs {

CloudLogReader::CloudLogReader(const std::string& path, const std::string& channel, double unit,
                               OnEvent on_event)
    : log_(path), channel_(channel), unit_(unit), on_event_(std::move(on_event)) {}

std::optional<LoggedCloud> CloudLogReader::next() {
  while (const auto event = log_.next()) {
    ++read_;
    ++channels_[event->channel];
    if (on_event_) on_event_(*event);
    if (!channel_.empty() && event->channel != channel_) continue;
    bus::Decoded<bus::CloudMessage> decoded =
        bus::decode_cloud(event->bytes, bus::kMaxMessageBytes, bus::CloudColours::kKeep, unit_);
    if (auto* message = std::get_if<bus::CloudMessage>(&decoded)) {
      return LoggedCloud{std::move(*message), event->channel, event->utime};
    }
    const bus::RejectReason reason = std::get<bus::Rejection>(decoded).reason;
    const bool other_type = reason == bus::RejectReason::kUnknownType && channel_.empty();
    if (!other_type) rejected_.add(reason);
  }
  return std::nullopt;
}

double CloudLogReader::share() const {
  const auto events = log_.survey().events;
  return events > 0 ? static_cast<double>(read_) / static_cast<double>(events) : 1.0;
}

}  // namespace quadrille::logs
