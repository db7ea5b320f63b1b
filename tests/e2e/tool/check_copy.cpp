#include <optional>
#include <stdexcept>

#include "log/event_log.hpp"
#include "tool.hpp"

namespace quadrille::e2e {
namespace {

/// An event that outlives the next.
struct Kept {
  std::int64_t utime = 0;
  std::string channel;
  std::vector<std::byte> bytes;

  bool operator==(const Kept&) const = default;
};

std::optional<Kept> next(bus::LogReader& log) {
  const auto event = log.next();
  if (!event) return std::nullopt;
  return Kept{event->utime, event->channel, {event->bytes.begin(), event->bytes.end()}};
}

bool is_result(const Kept& event) {
  return event.channel != "POINT_CLOUD" && event.channel != "POSE";
}

}  // namespace

void check_copy(const std::string& source, const std::string& copy) {
  bus::LogReader wanted_log(source), log(copy);
  auto wanted = next(wanted_log);
  std::int64_t utime = 0;
  int results = 0;
  while (const auto event = next(log)) {
    if (wanted && *event == *wanted) {
      utime = event->utime;
      wanted = next(wanted_log);
    } else if (is_result(*event) && event->utime == utime) {
      ++results;
    } else {
      throw std::runtime_error(copy + ": an event on " + event->channel + " of time " +
                               std::to_string(event->utime) + " after one of " +
                               std::to_string(utime));
    }
  }
  if (wanted) throw std::runtime_error(copy + ": lacks an event on " + wanted->channel);
  if (results < kClouds) throw std::runtime_error(copy + ": too few results");
}

}  // namespace quadrille::e2e
