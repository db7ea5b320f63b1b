#include "process/planner/command_line.hpp"

#include <CLI/CLI.hpp>

#include "io/planner/config.hpp"

namespace quadrille {

PlannerCommandLine::PlannerCommandLine(CLI::App& app) {
  settings_.process.add_to(app, "plan");
  add_channel_option(app, "--cloud-channel", settings_.cloud_channel, "clouds");
  add_channel_option(app, "--quadrics-channel", settings_.quadrics_channel, "quadrics");
  add_channel_option(app, "--grasps-channel", settings_.grasps_channel, "grasps");
  add_channel_option(app, "--shapes-channel", settings_.shapes_channel, "collision shapes");
  add_channel_option(app, "--occupancy-channel", settings_.occupancy_channel, "occupancy");
  add_channel_option(app, "--status-channel", settings_.status_channel, "status");
  planner_.add_to(app, "franka");
  app.add_option("--config", config_, "Settings (TOML)")->type_name("FILE");
}

PlannerSettings PlannerCommandLine::settings() const {
  PlannerSettings settings = settings_;
  settings.plan = planner_.overrule(io::load_config(config_).planner);
  settings.gripper = planner_.gripper();
  return settings;
}

}  // namespace quadrille
