#include "process/detector/command_line.hpp"

#include <CLI/CLI.hpp>

#include "quadrille/bus/channel_pattern.hpp"

namespace quadrille {

DetectorCommandLine::DetectorCommandLine(CLI::App& app) {
  settings_.process.add_to(app, "cloud");
  add_pattern_option(app, "--in-channel", settings_.in_channel, "clouds");
  add_channel_option(app, "--out-channel", settings_.out_channel, "quadrics");
  add_channel_option(app, "--boxes-channel", settings_.boxes_channel, "boxes");
  add_channel_option(app, "--status-channel", settings_.status_channel, "status");
  add_channel_option(app, "--pose-channel", settings_.pose_channel,
                     "camera's poses (bot_core.pose_t) in a fixed frame");
  camera_.add_to(app, "--pose-channel");
  settings_.frames.add_to(app);
  detector_.add_to(app);
}

DetectorSettings DetectorCommandLine::settings() const {
  DetectorSettings settings = settings_;
  const DetectorSetup setup =
      detector_.overrule_for_planning(io::load_detector_config(detector_.config));
  settings.detector = setup.options;
  settings.track = setup.track;
  for (const std::string& warning : setup.warnings) {
    settings.warnings.push_back(detector_.config + ": " + warning);
  }
  settings.X_WK = camera_.X_WK;
  settings.process.check();
  check_poses(settings.frames, settings.X_WK.has_value(), settings.pose_channel,
              {settings.in_channel});
  if (bus::ChannelPattern(settings.in_channel).is_pattern() &&
      (settings.X_WK || !settings.pose_channel.empty())) {
    throw CLI::ValidationError(
        "--in-channel",
        "a pattern stands for several cameras, and poses are those of one; start a process for "
        "each");
  }
  check_distinct({{"--in-channel", settings.in_channel},
                  {"--out-channel", settings.out_channel},
                  {"--boxes-channel", settings.boxes_channel},
                  {"--status-channel", settings.status_channel},
                  {"--pose-channel", settings.pose_channel}});
  return settings;
}

}  // namespace quadrille
