#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quadrille/detector/options.hpp"
#include "quadrille/detector/tracker.hpp"

namespace quadrille {

/// The detector's options on the command line, shared by the commands that detect.
struct DetectorArguments {
  std::string config, only;
  std::optional<std::uint64_t> seed;
  std::optional<int> threads;

  /// Adds --config, --only, --seed and --threads; this must outlive the app.
  void add_to(CLI::App& command);
  /// The settings of the file, overruled by those of the command line.
  /// @throws io::FileError if the file is wrong
  DetectorOptions options() const;
  /// The settings of the tracker, from the file.
  /// @throws io::FileError if the file is wrong
  TrackOptions track_options() const;
  /// What of the file is not heeded, one line each.
  /// @throws io::FileError if the file is wrong
  std::vector<std::string> warnings() const;
};

}  // namespace quadrille
