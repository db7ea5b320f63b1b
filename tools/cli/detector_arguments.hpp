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
  std::string config;
  /// Empty: as the file says.
  std::vector<QuadricType> only, report;
  std::optional<std::uint64_t> seed;
  std::optional<int> threads;

  /// Adds --config, --only, --report, --seed and --threads; this must outlive the app.
  void add_to(CLI::App& command);
  /// The settings of the file, overruled by those of the command line.
  DetectorSetup overrule(const io::DetectorConfig& file) const;
  /// The same for what grasps are planned on: types that were not asked for are found all the same,
  /// as they are in the way. What was to be found alone is reported alone.
  DetectorSetup overrule_for_planning(const io::DetectorConfig& file) const;

 private:
  DetectorSetup given(const io::DetectorConfig& file) const;
};

}  // namespace quadrille
