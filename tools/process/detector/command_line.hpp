#pragma once

#include "cli/detector_arguments.hpp"
#include "cli/frame_arguments.hpp"
#include "process/detector/settings.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The command line options of the process.
class DetectorCommandLine {
 public:
  /// Adds the options to an app, which must not outlive this object.
  explicit DetectorCommandLine(CLI::App& app);

  /// Returns the settings, once the app has parsed the options.
  /// @throws io::FileError if the configuration file is wrong
  DetectorSettings settings() const;

 private:
  void name_channels(DetectorSettings* settings) const;

  DetectorSettings settings_;
  DetectorArguments detector_;
  CameraPoseArgument camera_;
};

}  // namespace quadrille
