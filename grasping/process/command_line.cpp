#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>

#include "config.hpp"
#include "io/gripper_file.hpp"
#include "quadrille/bus/connection.hpp"
#include "unknown_policy.hpp"

namespace quadrille {
namespace {

std::string check_channel_argument(const std::string& channel) try {
  bus::check_channel(channel);
  return {};
} catch (const std::exception& error) {
  return error.what();
}

void add_channel(CLI::App& app, const std::string& name, std::string& channel,
                 const std::string& what) {
  app.add_option(name, channel, "channel of the " + what)
      ->check(check_channel_argument)
      ->capture_default_str();
}

void add_bus_options(CLI::App& app, PlannerSettings& settings) {
  app.add_option("-l,--lcm-url", settings.lcm_url, "LCM address; else LCM_DEFAULT_URL");
  add_channel(app, "--cloud-channel", settings.cloud_channel, "clouds");
  add_channel(app, "--quadrics-channel", settings.quadrics_channel, "quadrics");
  add_channel(app, "--grasps-channel", settings.grasps_channel, "grasps");
  add_channel(app, "--shapes-channel", settings.shapes_channel, "collision shapes");
  add_channel(app, "--occupancy-channel", settings.occupancy_channel, "occupancy");
  add_channel(app, "--status-channel", settings.status_channel, "status");
}

void add_log_options(CLI::App& app, PlannerSettings& settings) {
  auto* in = app.add_option("--in-log", settings.in_log,
                            "replay this log of clouds and quadrics, every pair in order");
  auto* out = app.add_option("--out-log", settings.out_log, "write what is published to this log");
  auto* copy = app.add_flag("--copy-input", settings.copy_input,
                            "copy the replayed events to the written log too");
  in->needs(out);
  out->needs(in);
  copy->needs(in);
  in->excludes("--lcm-url");
}

}  // namespace

PlannerSettings parse_command_line(int argc, const char* const* argv) {
  CLI::App app("Plans grasps on the quadrics and clouds of LCM channels.",
               "quadrille-grasp-planner");
  PlannerSettings settings;
  std::string gripper = "franka", unknown, config;
  add_bus_options(app, settings);
  add_log_options(app, settings);
  app.add_option("--gripper", gripper, "name of a gripper, or its TOML file")
      ->capture_default_str();
  app.add_option("--unknown", unknown, "what unobserved space counts as")
      ->check(CLI::IsMember({"obstacle", "target-shadow", "free"}));
  app.add_option("--config", config, "TOML file with settings of the planner")
      ->check(CLI::ExistingFile);
  app.add_flag("-v,--verbose", settings.verbose, "log every plan");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Only the app can print help and errors; 0 is help, all else is wrong usage.
    std::exit(app.exit(error) == 0 ? 0 : 2);
  }
  if (!config.empty()) settings.plan = load_plan_options(config);
  if (!unknown.empty()) settings.plan.unknown = unknown_policy_from_string(unknown).value();
  settings.gripper = io::load_gripper(gripper);
  return settings;
}

}  // namespace quadrille
