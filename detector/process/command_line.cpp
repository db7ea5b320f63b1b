#include "command_line.hpp"

namespace quadrille {

CommandLine::CommandLine(CLI::App& app) {
  settings_.process.add_to(app, "cloud");
  add_channel_option(app, "--in-channel", settings_.in_channel, "clouds");
  add_channel_option(app, "--out-channel", settings_.out_channel, "quadrics");
  add_channel_option(app, "--status-channel", settings_.status_channel, "status");
  detector_.add_to(app);
}

DetectorSettings CommandLine::settings() const {
  DetectorSettings settings = settings_;
  settings.detector = detector_.options();
  settings.detector.check();
  return settings;
}

}  // namespace quadrille
