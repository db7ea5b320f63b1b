#include "quadrille/show_command.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "cli/output.hpp"
#include "cli/process_arguments.hpp"
#include "io/describe.hpp"
#include "log/event_log.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
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
  std::size_t quadrics = 0, boxes = 0, grasps = 0, refused = 0;
};

/// Prints the event if it holds quadrics, boxes or grasps; damaged ones are counted.
void show(const bus::LogReader::Event& event, std::size_t max_grasps, Shown* shown) {
  const auto quadrics = bus::decode_quadrics(event.bytes);
  if (const auto* message = std::get_if<bus::QuadricsMessage>(&quadrics)) {
    print(published_table(event.channel, *message));
    ++shown->quadrics;
    return;
  }
  const auto grasps = bus::decode_grasps(event.bytes);
  if (const auto* message = std::get_if<grasps_t>(&grasps)) {
    print(published_table(event.channel, *message, max_grasps));
    ++shown->grasps;
    return;
  }
  const auto boxes = bus::decode_boxes(event.bytes);
  if (const auto* message = std::get_if<bus::BoxesMessage>(&boxes)) {
    print(published_table(event.channel, *message));
    ++shown->boxes;
    return;
  }
  const auto of_other_type = [](const auto& decoded) {
    return std::get<bus::Rejection>(decoded).reason == bus::RejectReason::kUnknownType;
  };
  if (!of_other_type(quadrics) || !of_other_type(grasps) || !of_other_type(boxes)) {
    ++shown->refused;
  }
}

/// @param channels  number of events of each channel of the log
std::string describe_nothing(const std::string& channel,
                             const std::map<std::string, std::int64_t>& channels) {
  if (channel.empty() || channels.empty()) {
    return "holds no quadrics and no grasps; record QUADRICS and GRASPS";
  }
  return fmt::format(
      "holds no quadrics, boxes or grasps on {}, but events on {}; name another --channel",
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
  if (shown.refused > 0) {
    warnings.push_back(io::count_of(shown.refused, "message") +
                       " of quadrics, boxes or grasps damaged");
  }
  if (shown.quadrics + shown.boxes + shown.grasps == 0) {
    warnings.push_back(describe_nothing(arguments.channel, channels));
  }
  print_warnings(arguments.log, warnings);
}

}  // namespace

void add_show_command(CLI::App& app) {
  auto arguments = std::make_shared<ShowArguments>();
  CLI::App* command =
      app.add_subcommand("show", "Print the quadrics and grasps that an LCM log holds");
  command->add_option("LOG", arguments->log, "What was recorded on the bus (.lcm)")->required();
  add_channel_option(*command, "--channel", arguments->channel, "messages to print; else all");
  command->add_option("--max-grasps", arguments->max_grasps, "Grasps to print of each cloud")
      ->type_name("N");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
