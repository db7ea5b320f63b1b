#include "quadrille/bus/replay.hpp"

#include "quadrille/bus/stop.hpp"
#include "quadrille/bus/url.hpp"

namespace quadrille::bus {

LogSurvey replay_log(const std::string& path, const Connection::Handler& handler) {
  LogSurvey survey = survey_log(path);
  // LCM refuses to open a log without events.
  if (survey.events == 0) return survey;
  Connection connection(replay_url(path));
  connection.subscribe_all(handler);
  constexpr int kWaitMs = 1000;
  while (!stop_requested() && connection.handle(kWaitMs) != Connection::Outcome::kEnd) {
  }
  return survey;
}

}  // namespace quadrille::bus
