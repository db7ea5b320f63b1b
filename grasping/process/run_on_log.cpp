#include <spdlog/spdlog.h>

#include <stdexcept>

#include "node.hpp"
#include "quadrille/bus/event_log.hpp"
#include "quadrille/bus/replay.hpp"
#include "run.hpp"

namespace quadrille {

void run_on_log(const PlannerSettings& settings) {
  bus::check_different_files(settings.process.in_log, settings.process.out_log);
  bus::survey_log(settings.process.in_log);
  bus::LogWriter out(settings.process.out_log);
  // Events are stamped with the clouds' own time, so that the log is the same in every run.
  std::int64_t utime = 0;
  PlannerNode node(settings, [&](const std::string& channel, std::span<const std::byte> bytes) {
    out.write(utime, channel, bytes);
  });
  const auto on_event = [&](const std::string& channel, std::span<const std::byte> bytes) {
    const auto pair = node.receive(channel, bytes);
    utime = node.last_utime();
    if (settings.process.copy_input) out.write(utime, channel, bytes);
    if (pair) node.handle(*pair);
  };
  const bus::LogSurvey survey = bus::replay_log(settings.process.in_log, on_event);
  std::vector<std::string> warnings;
  if (survey.defect) warnings.push_back(settings.process.in_log + ": " + *survey.defect);
  if (node.paired() == 0) {
    warnings.push_back(settings.process.in_log + ": no quadrics with their cloud; make it with " +
                       "quadrille-detector --copy-input");
  }
  for (const std::string& warning : warnings) spdlog::warn("{}", warning);
  node.publish_status(0, warnings);
  out.flush();
  if (node.failed() > 0) {
    throw std::runtime_error(settings.process.in_log + ": the planning failed on " +
                             std::to_string(node.failed()) + " clouds; the records above say why");
  }
}

}  // namespace quadrille
