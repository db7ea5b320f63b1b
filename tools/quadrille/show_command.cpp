#include "quadrille/show_command.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "cli/output.hpp"
#include "cli/process_arguments.hpp"
#include "io/describe.hpp"
#include "log/event_log.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/body_tracks_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/status_message.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/published_table.hpp"

namespace quadrille {
namespace {

struct ShowArguments {
  std::string log, channel;
  std::size_t max_grasps = 5;
};

/// Counts of what was found in a log so far.
struct Shown {
  std::size_t messages = 0, damaged = 0;
};

/// Prints an event if it decodes to one kind of message.
/// @param limits  arguments that the table of this kind takes besides
/// @return false if it is of another type
template <class Message, class... Limits>
bool show_as(const std::string& channel, const bus::Decoded<Message>& decoded, Shown* shown,
             Limits... limits) {
  if (const auto* const message = std::get_if<Message>(&decoded)) {
    print(published_table(channel, *message, limits...));
    ++shown->messages;
    return true;
  }
  if (std::get<bus::Rejection>(decoded).reason == bus::RejectReason::kUnknownType) return false;
  ++shown->damaged;
  return true;
}

/// Prints the event if it holds quadrics, boxes, bodies, their tracks, grasps or the status of a
/// process.
void show(const bus::LogReader::Event& event, std::size_t max_grasps, Shown* shown) {
  const std::string& channel = event.channel;
  const std::span<const std::byte> bytes = event.bytes;
  if (show_as(channel, bus::decode_quadrics(bytes), shown)) return;
  if (show_as(channel, bus::decode_grasps(bytes), shown, max_grasps)) return;
  if (show_as(channel, bus::decode_boxes(bytes), shown)) return;
  if (show_as(channel, bus::decode_bodies(bytes), shown)) return;
  if (show_as(channel, bus::decode_body_tracks(bytes), shown)) return;
  if (show_as(channel, bus::decode_detector_status(bytes), shown)) return;
  show_as(channel, bus::decode_planner_status(bytes), shown);
}

/// @param channels  number of events of each channel of the log
std::string describe_nothing(const std::string& channel,
                             const std::map<std::string, std::int64_t>& channels) {
  if (channel.empty() || channels.empty()) {
    return "holds no quadrics, boxes, bodies, grasps or status; record QUADRICS and GRASPS";
  }
  return fmt::format(
      "holds no quadrics, boxes, bodies, grasps or status on {}, but events on {}; name another "
      "--channel",
      printable(channel), io::list_channels(channels));
}

void run(const ShowArguments& arguments) {
  bus::LogReader log(arguments.log);
  Shown shown;
  std::map<std::string, std::int64_t> channels;
  while (const auto event = log.next()) {
    ++channels[event->channel];
    const bool wanted = arguments.channel.empty() || event->channel == arguments.channel;
    if (wanted) show(*event, arguments.max_grasps, &shown);
  }
  std::vector<std::string> warnings;
  if (log.survey().defect) warnings.push_back(*log.survey().defect);
  if (shown.damaged > 0) {
    warnings.push_back(io::count_of(shown.damaged, "message") +
                       " of quadrics, boxes, bodies, grasps or status damaged");
  }
  if (shown.messages == 0) {
    warnings.push_back(describe_nothing(arguments.channel, channels));
  }
  print_warnings(arguments.log, warnings);
}

}  // namespace

void add_show_command(CLI::App& app) {
  auto arguments = std::make_shared<ShowArguments>();
  CLI::App* command = app.add_subcommand(
      "show",
      "Print the quadrics, bodies, grasps and status of the processes that an LCM log holds");
  command->add_option("LOG", arguments->log, "What was recorded on the bus (.lcm)")->required();
  add_channel_option(*command, "--channel", arguments->channel, "messages to print; else all");
  command->add_option("--max-grasps", arguments->max_grasps, "Grasps to print of each cloud")
      ->type_name("N");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
