#include "process/planner/command_line.hpp"

#include <CLI/CLI.hpp>

#include "cli/planner/query_arguments.hpp"
#include "cli/planner/surroundings_arguments.hpp"
#include "cli/robot_option.hpp"
#include "cli/types_option.hpp"
#include "io/planner/config.hpp"

namespace quadrille {
namespace {

// A waiting robot is better served by some grasps now than by all of them later [ms]. Plans on a
// log have no deadline, so that every replay gives the same ones.
constexpr double kLiveDeadline = 500.0;

}  // namespace

PlannerCommandLine::PlannerCommandLine(CLI::App& app) {
  // Without this, the detector takes half as long again if there are few cores.
  settings_.process.niceness = 5;
  // Few programs use the map, and it takes a tenth of the time of a plan.
  settings_.occupancy_period = 1.0;
  settings_.process.add_to(app, "plan");
  PlannerSettings::visit_channels(
      settings_, [&](Way, const char* option, std::string& name, const char* what) {
        add_channel_option(app, option, name, what);
      });
  app.add_flag("--on-request", settings_.on_request,
               "Plan only what is asked for, and not on each cloud");
  app.add_flag("!--no-shapes", settings_.shapes, "Publish no collision shapes");
  app.add_flag("!--no-occupancy", settings_.occupancy, "Publish no occupancy");
  app.add_option("--occupancy-period", settings_.occupancy_period,
                 "On the bus, publish occupancy at most once in so many seconds; 0: with each plan")
      ->check(CLI::Range(0.0, 3600.0))
      ->type_name("SECONDS")
      ->capture_default_str();
  app.add_option("--nice", settings_.process.niceness,
                 "On the bus, let planning give way to other processes by so much, as nice does")
      ->check(CLI::Range(0, 19))
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("--viz", settings_.viz,
               "Also publish the hand at the best grasp for Meldis, Drake's viewer");
  camera_.add_to(app, "--pose-channel");
  settings_.frames.add_to(app);
  add_view_camera_option(app, settings_.view_cameras);
  planner_.add_to(app, "franka");
  const std::string frame = "the fixed frame of the camera's poses, else in the camera's";
  add_approach_option(app, settings_.approach, frame);
  add_obstacles_option(app, settings_.obstacles, frame);
  add_attached_option(app, settings_.attached);
  add_robot_option(app, settings_.known.robot, frame);
  add_surroundings_options(app, settings_.known, frame);
  add_types_option(app, "--report", report_, "Grasp only these types; the others stay in the way");
  app.add_option("--config", config_, "Settings (TOML)")->type_name("FILE");
}

PlannerSettings PlannerCommandLine::settings() const {
  PlannerSettings settings = settings_;
  const io::Config config = io::load_config(config_);
  settings.plan = planner_.overrule(config.planner);
  const bool deadline_given = planner_.deadline_ms || config.given.contains("planner.deadline_ms");
  if (settings.process.in_log.empty() && !deadline_given) settings.plan.deadline_ms = kLiveDeadline;
  if (!report_.empty()) settings.plan.targets = report_;
  settings.pose_age = config.track.pose_age;
  settings.pose_wait = config.track.pose_wait;
  settings.X_WK = camera_.X_WK;
  settings.detector = config.detector;
  const Surroundings& known = settings.known;
  const bool any_known = !settings.obstacles.empty() || !known.robot.shapes.empty() ||
                         known.support.has_value() || known.map.tree != nullptr;
  settings.frames.conditions = settings.has_fixed_frame() &&
                               (settings.approach || settings.plan.reach.max > 0.0 || any_known);
  settings.process.check();
  PlannerSettings::visit_channels(settings, [&](Way, const char*, std::string& name, const char*) {
    name = settings.process.prefixed(name);
  });
  check_poses(settings.frames, settings.X_WK.has_value(), settings.pose_channel,
              {settings.cloud_channel, settings.quadrics_channel, settings.request_channel});
  check_view_cameras(settings.view_cameras, settings.has_fixed_frame(), settings.detector.views);
  std::vector<NamedChannel> channels = channels_of(settings);
  PlannerSettings::visit_viewer(settings, [&](std::string& name) {
    name = settings.process.prefixed(name);
    channels.push_back({"--viz", name});
  });
  check_distinct(channels);
  settings.gripper = planner_.gripper();
  return settings;
}

}  // namespace quadrille
