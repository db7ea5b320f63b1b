#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/config.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// With what a command detects and tracks.
struct DetectorSetup {
  DetectorOptions options;
  TrackOptions track;
  /// What of the file is not heeded, one line each.
  std::vector<std::string> warnings;
};

/// The detector's options on the command line, shared by the commands that detect.
struct DetectorArguments {
  std::string config, only;
  std::optional<std::uint64_t> seed;
  std::optional<int> threads;

  /// Adds --config, --only, --seed and --threads; this must outlive the app.
  void add_to(CLI::App& command);
  /// The settings of the file, overruled by those of the command line.
  DetectorSetup overrule(const io::DetectorConfig& file) const;
};

}  // namespace quadrille
