#include "quadrille/bus/replay.hpp"

#include "quadrille/bus/stop.hpp"

namespace quadrille::bus {

LogSurvey replay_log(const std::string& path, const EventHandler& handler) {
  LogReader log(path);
  while (!stop_requested()) {
    const auto event = log.next();
    if (!event) break;
    handler(*event);
  }
  return log.survey();
}

}  // namespace quadrille::bus
