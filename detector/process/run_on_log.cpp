#include <spdlog/spdlog.h>

#include <stdexcept>

#include "node.hpp"
#include "quadrille/bus/event_log.hpp"
#include "quadrille/bus/replay.hpp"
#include "run.hpp"

namespace quadrille {
void run_on_log(const DetectorSettings& settings) {
  bus::check_different_files(settings.process.in_log, settings.process.out_log);
  bus::survey_log(settings.process.in_log);
  bus::LogWriter out(settings.process.out_log);
  // Events are stamped with the clouds' own time, so that the log is the same in every run.
  std::int64_t utime = 0;
  DetectorNode node(settings, [&](const std::string& channel, std::span<const std::byte> bytes) {
    out.write(utime, channel, bytes);
  });
  const auto on_event = [&](const std::string& channel, std::span<const std::byte> bytes) {
    std::optional<ReceivedCloud> cloud;
    if (channel == settings.in_channel) cloud = node.receive(bytes);
    if (cloud) utime = cloud->message.utime;
    if (settings.process.copy_input) out.write(utime, channel, bytes);
    if (cloud) node.handle(*cloud);
  };
  const bus::LogSurvey survey = bus::replay_log(settings.process.in_log, on_event);
  std::vector<std::string> warnings;
  if (survey.defect) warnings.push_back(settings.process.in_log + ": " + *survey.defect);
  for (const std::string& warning : warnings) spdlog::warn("{}", warning);
  node.publish_status(0, warnings);
  out.flush();
  if (node.failed() > 0) {
    throw std::runtime_error(settings.process.in_log + ": the detection failed on " +
                             std::to_string(node.failed()) + " clouds; the records above say why");
  }
}

}  // namespace quadrille
