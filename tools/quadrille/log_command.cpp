#include "quadrille/log_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/process_arguments.hpp"
#include "io/cloud_file.hpp"
#include "logs/cloud_log_writer.hpp"

namespace quadrille {
namespace {

struct LogArguments {
  std::string out;
  std::vector<std::string> inputs;
  std::string format = "drake";
  logs::CloudLogOptions options;
};

void run(const LogArguments& arguments) {
  // A bad input must not leave an empty log, so the first one is read before the log is made.
  PointCloud cloud = io::read_cloud(arguments.inputs.front());
  logs::CloudLogWriter writer(arguments.out, arguments.options);
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i) {
    if (i > 0) cloud = io::read_cloud(arguments.inputs[i]);
    if (!cloud.viewpoint.isZero(0.0)) {
      fmt::print(stderr, "{}: LCM clouds have no viewpoint; readers will assume the origin\n",
                 arguments.inputs[i]);
    }
    writer.write(cloud);
  }
  writer.flush();
  fmt::print("{}: {} clouds, {:.1f} MB, on {} at {} Hz\n", arguments.out, writer.clouds(),
             static_cast<double>(writer.bytes()) * 1e-6, arguments.options.channel,
             arguments.options.rate);
}

}  // namespace

void add_log_command(CLI::App& app) {
  auto arguments = std::make_shared<LogArguments>();
  CLI::App* command = app.add_subcommand("log", "Write clouds as an LCM log");
  command->add_option("OUT", arguments->out, "The log to write (.lcm)")->required();
  command->add_option("INPUT", arguments->inputs, "Clouds (.ply, .pcd), in order")->required();
  command->add_option("--rate", arguments->options.rate, "Clouds per second")
      ->check(CLI::Range(0.001, 10000.0))
      ->type_name("HZ");
  add_channel_option(*command, "--channel", arguments->options.channel, "clouds");
  command->add_option("--as", arguments->format, "Their message type")
      ->check(CLI::IsMember({"drake", "pointcloud2", "pointcloud"}).description(""))
      ->type_name("drake|pointcloud2|pointcloud");
  command->callback([arguments] {
    arguments->options.format = bus::cloud_format_from_string(arguments->format).value();
    run(*arguments);
  });
}

}  // namespace quadrille
