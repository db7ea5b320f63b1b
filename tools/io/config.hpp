#pragma once

#include <set>
#include <string>
#include <string_view>

#include "quadrille/detector/options.hpp"
#include "quadrille/detector/tracker.hpp"

namespace quadrille::io {

/// What a file of settings says to the detector.
struct DetectorConfig {
  DetectorOptions detector;
  TrackOptions track;
  /// The keys that it gives, such as "search.basis".
  std::set<std::string> given;
};

/// Reads the detector's part of a TOML file that all programs may share; the table [planner] is
/// left to the planner. Keys and ranges are those of DetectorOptions::visit() and
/// TrackOptions::visit(). What the file leaves out keeps its default. Keys as earlier versions
/// spelt them, such as planes.least_samples, are read too.
/// @param path  empty for the defaults
/// @throws FileError naming line and key if the file is missing or no TOML, if a key is unknown, or
///         if a value has the wrong type or is out of range
DetectorConfig load_detector_config(const std::string& path);

/// The same from the text of such a file.
/// @param path  what it is called in errors
DetectorConfig parse_detector_config(std::string_view text, const std::string& path);

}  // namespace quadrille::io
