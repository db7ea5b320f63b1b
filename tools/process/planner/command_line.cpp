#include "process/planner/command_line.hpp"

#include "io/config.hpp"

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
  if (!config_.empty()) settings.plan = io::load_settings(config_).planner;
  settings.plan.unknown = planner_.unknown.value_or(settings.plan.unknown);
  settings.gripper = planner_.gripper();
  return settings;
}

}  // namespace quadrille
