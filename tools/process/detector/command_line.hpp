#pragma once

#include "cli/detector_arguments.hpp"
#include "cli/frame_arguments.hpp"
#include "process/detector/settings.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The options of the process.
class DetectorCommandLine {
 public:
  /// Adds them to an app, which must not outlive this.
  explicit DetectorCommandLine(CLI::App& app);

  /// What they ask for, once the app has read them.
  /// @throws io::FileError if the configuration file is wrong
  DetectorSettings settings() const;

 private:
  void name_channels(DetectorSettings* settings) const;

  DetectorSettings settings_;
  DetectorArguments detector_;
  CameraPoseArgument camera_;
};

}  // namespace quadrille
