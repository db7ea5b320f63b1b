#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/settings/config.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The settings with which a command detects and tracks.
struct DetectorSetup {
  DetectorOptions options;
  TrackOptions track;
};

/// The detector's options on the command line, shared by the commands that detect.
struct DetectorArguments {
  std::string config;
  /// Types from the command line; if empty, those of the file are used.
  std::vector<QuadricType> only, report;
  std::optional<std::uint64_t> seed;
  std::optional<int> threads;

  /// Adds --config, --only, --report, --seed and --threads; this object must outlive the app.
  void add_to(CLI::App& command);
  /// Returns the settings of the file, overridden by those of the command line, on top of the
  /// preset if only spheres are sought; see io::search_options().
  DetectorSetup overrule(io::DetectorConfig file) const;
  /// Like overrule(), for detections on which grasps are planned. Types that were not asked for are
  /// detected too, because they are obstacles; --only limits the report instead of the search.
  DetectorSetup overrule_for_planning(const io::DetectorConfig& file) const;

 private:
  DetectorOptions over(DetectorOptions options) const;
};

}  // namespace quadrille
