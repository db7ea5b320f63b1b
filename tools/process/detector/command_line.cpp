#include "process/detector/command_line.hpp"

#include <CLI/CLI.hpp>

#include "cli/robot_option.hpp"
#include "link/channel_pattern.hpp"

namespace quadrille {

DetectorCommandLine::DetectorCommandLine(CLI::App& app) {
  settings_.process.add_to(app, "cloud");
  DetectorSettings::visit_channels(
      settings_, [&](Way, const char* option, std::string& name, const char* what) {
        const bool may_be_pattern = &name == &settings_.in_channel;
        (may_be_pattern ? add_pattern_option : add_channel_option)(app, option, name, what);
      });
  app.add_flag("--viz", settings_.viz,
               "Also publish the cloud and what is found for Meldis, Drake's viewer");
  camera_.add_to(app, "--pose-channel");
  settings_.frames.add_to(app);
  add_view_camera_option(app, settings_.view_cameras);
  add_robot_option(app, settings_.robot,
                   "the fixed frame of the camera's poses, else in the camera's");
  detector_.add_to(app);
}

DetectorSettings DetectorCommandLine::settings() const {
  DetectorSettings settings = settings_;
  const DetectorSetup setup =
      detector_.overrule_for_planning(io::load_detector_config(detector_.config));
  settings.detector = setup.options;
  settings.track = setup.track;
  settings.X_WK = camera_.X_WK;
  settings.frames.conditions = settings.has_fixed_frame() && !settings.robot.shapes.empty();
  settings.process.check();
  name_channels(&settings);
  check_poses(settings.frames, settings.X_WK.has_value(), settings.pose_channel,
              {settings.in_channel});
  if (bus::ChannelPattern(settings.in_channel).is_pattern() &&
      (settings.X_WK || !settings.pose_channel.empty())) {
    throw CLI::ValidationError(
        "--in-channel",
        "a pattern stands for several cameras, and poses are those of one; start a process for "
        "each");
  }
  check_view_cameras(settings.view_cameras, settings.has_fixed_frame(), settings.detector.views);
  std::vector<NamedChannel> channels = channels_of(settings);
  DetectorSettings::visit_viewer(settings, [&](const std::string& name) {
    channels.push_back({"--viz", name});
  });
  check_distinct(channels);
  return settings;
}

void DetectorCommandLine::name_channels(DetectorSettings* settings) const {
  const ProcessArguments& process = settings->process;
  DetectorSettings::visit_channels(*settings, [&](Way, const char*, std::string& name,
                                                  const char*) { name = process.prefixed(name); });
  DetectorSettings::visit_viewer(*settings,
                                 [&](std::string& name) { name = process.prefixed(name); });
}

}  // namespace quadrille
