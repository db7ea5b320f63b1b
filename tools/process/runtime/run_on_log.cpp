#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "process/runtime/channel_census.hpp"
#include "process/runtime/logging.hpp"
#include "process/runtime/run.hpp"
#include "process/runtime/stats_file.hpp"
#include "quadrille/bus/event_log.hpp"
#include "quadrille/bus/replay.hpp"
#include "quadrille/bus/stop.hpp"

namespace quadrille {
namespace {

std::vector<std::string> find_warnings(const bus::LogSurvey& survey, const ChannelCensus& census,
                                       const Node& node) {
  std::vector<std::string> warnings = census.find_missing(node.in_channels());
  if (survey.defect) warnings.push_back(*survey.defect);
  for (std::string& oddity : node.find_oddities()) warnings.push_back(std::move(oddity));
  return warnings;
}

/// What to tell of a replay that was stopped before its end; empty if it was not.
std::string describe_stop(std::int64_t done, const bus::LogSurvey& survey,
                          const ProcessArguments& arguments) {
  if (!bus::stop_requested() || done >= survey.events) return "";
  return fmt::format(
      "{}: stopped before the end of the log, after {} of {} events; {} holds only "
      "what came of these",
      arguments.in_log, done, survey.events, arguments.out_log);
}

/// Refuses to copy results of earlier runs among new ones, which no reader could tell apart.
void check_unmixed(const std::string& path, const std::vector<OutChannel>& channels) {
  ChannelCensus census;
  bus::LogReader log(path);
  while (const auto event = log.next()) census.add(event->channel);
  const std::string taken = census.find_taken(channels);
  if (taken.empty()) return;
  throw std::runtime_error(
      fmt::format("{}: with --copy-input its events would be mixed with new results on {}; publish "
                  "on another channel with the option named, or leave out --copy-input",
                  path, taken));
}

}  // namespace

void run_on_log(const ProcessArguments& arguments, const NodeMaker& make_node) {
  bus::check_different_files(arguments.in_log, arguments.out_log);
  bus::survey_log(arguments.in_log);
  StatsFile stats(arguments.stats_file);
  std::optional<bus::LogWriter> out;
  // Results carry the time of the event that they answer: it is the same in every run, and later
  // than that of no event which is copied after them.
  std::int64_t utime = 0;
  const auto node = make_node([&](const std::string& channel, std::span<const std::byte> bytes) {
    out->write(utime, channel, bytes);
  });
  if (arguments.copy_input) check_unmixed(arguments.in_log, node->out_channels());
  out.emplace(arguments.out_log);
  ChannelCensus census;
  std::int64_t done = 0;
  const auto on_event = [&](const bus::LogReader::Event& event) {
    ++done;
    utime = event.utime;
    census.add(event.channel);
    if (arguments.copy_input) out->write(event.utime, event.channel, event.bytes);
    if (const auto job = node->receive(event.channel, event.bytes)) node->work(*job);
  };
  const bus::LogSurvey survey = bus::replay_log(arguments.in_log, on_event);
  const std::string stopped = describe_stop(done, survey, arguments);
  // What is missing from half a log tells nothing of the log.
  std::vector<std::string> warnings =
      stopped.empty() ? find_warnings(survey, census, *node) : std::vector<std::string>{};
  for (std::string& warning : warnings) {
    warning = arguments.in_log + ": " + warning;
    log_warning(warning);
  }
  if (!stopped.empty()) warnings.push_back(stopped);
  node->publish_status(0, warnings);
  stats.write(node->exposition());
  out->flush();
  if (!stopped.empty()) throw std::runtime_error(stopped);
  log_info(arguments.in_log + ": " + node->summary());
  if (node->failed() == 0) return;
  throw std::runtime_error(fmt::format("{}: {} of its clouds failed; the records above say why",
                                       arguments.in_log, node->failed()));
}

}  // namespace quadrille
