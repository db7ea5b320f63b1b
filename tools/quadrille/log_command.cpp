#include "quadrille/log_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/choice_option.hpp"
#include "cli/process_arguments.hpp"
#include "cli/rate_option.hpp"
#include "cli/unit_option.hpp"
#include "io/cloud_file.hpp"
#include "io/describe.hpp"
#include "io/new_file.hpp"
#include "logs/cloud_log_writer.hpp"
#include "quadrille/detector/cloud_checks.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

struct LogArguments {
  std::string out;
  std::vector<std::string> inputs;
  double unit = 1.0;  ///< of the inputs' coordinates [m]
  logs::CloudLogOptions options;
};

void run(const LogArguments& arguments) {
  io::NewFile file(arguments.out);
  logs::CloudLogWriter writer(file.path(), arguments.options, arguments.out);
  for (const std::string& input : arguments.inputs) {
    const PointCloud cloud = io::read_cloud(input, Eigen::Affine3d(Eigen::Scaling(arguments.unit)));
    const std::string doubt = contradict_viewpoint(cloud, {});
    if (arguments.unit != 1.0 && !doubt.empty()) {
      fmt::print(stderr, "{}: warning: {}\n", printable(input, kMaxPath), doubt);
    }
    if (!cloud.viewpoint.isZero(0.0)) {
      fmt::print(stderr, "{}: LCM clouds have no viewpoint; readers will assume the origin\n",
                 printable(input, kMaxPath));
    }
    writer.write(cloud);
  }
  writer.flush();
  file.commit();
  const auto clouds = static_cast<std::size_t>(writer.clouds());
  fmt::print("{}: {}, {:.1f} MB, on {} at {} Hz\n", arguments.out, io::count_of(clouds, "cloud"),
             static_cast<double>(writer.bytes()) * 1e-6, arguments.options.channel,
             arguments.options.rate);
}

}  // namespace

void add_log_command(CLI::App& app) {
  auto arguments = std::make_shared<LogArguments>();
  CLI::App* command = app.add_subcommand("log", "Write clouds as an LCM log");
  command->add_option("OUT", arguments->out, "The log to write (.lcm)")->required();
  command->add_option("INPUT", arguments->inputs, "Clouds (.ply, .pcd), in order")->required();
  add_unit_option(*command, arguments->unit);
  add_rate_option(*command, arguments->options.rate, logs::kMinRate, logs::kMaxRate);
  add_channel_option(*command, "--channel", arguments->options.channel, "clouds");
  Choices<bus::CloudFormat> formats;
  for (const bus::CloudFormat format : bus::all_cloud_formats()) {
    formats.emplace_back(bus::to_string(format), format);
  }
  add_choice_option(*command, "--as", arguments->options.format, formats, "Their message type");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
