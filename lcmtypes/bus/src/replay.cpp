#include "quadrille/bus/replay.hpp"

#include <stdexcept>

#include "quadrille/bus/connection.hpp"
#include "quadrille/bus/stop.hpp"
#include "quadrille/bus/url.hpp"

namespace quadrille::bus {
namespace {

/// The time of the next event that is the one which LCM delivers: it passes over those whose
/// channel has a name that it cannot read.
std::int64_t find_utime(LogReader& log, const std::string& channel,
                        std::span<const std::byte> bytes) {
  while (const auto event = log.next()) {
    if (event->channel == channel && event->bytes.size() == bytes.size()) return event->utime;
  }
  throw std::runtime_error("the log changes while it is read; wait until it is written");
}

}  // namespace

LogSurvey replay_log(const std::string& path, const EventHandler& handler) {
  LogSurvey survey = survey_log(path);
  // LCM refuses to open a log without events.
  if (survey.events == 0) return survey;
  Connection connection(replay_url(path));
  // Beside LCM, whose file provider tells the time of the replay and not that of the event.
  LogReader log(path);
  connection.subscribe_all([&](const std::string& channel, std::span<const std::byte> bytes) {
    handler({find_utime(log, channel, bytes), channel, bytes});
  });
  constexpr int kWaitMs = 1000;
  while (!stop_requested() && connection.handle(kWaitMs) != Connection::Outcome::kEnd) {
  }
  return survey;
}

}  // namespace quadrille::bus
