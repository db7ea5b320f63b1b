#pragma once

#include <set>
#include <string>
#include <string_view>

#include "quadrille/detector/options.hpp"
#include "quadrille/detector/tracker.hpp"

namespace quadrille::io {

/// The detector's settings from a file.
struct DetectorConfig {
  DetectorOptions detector;
  TrackOptions track;
  /// The keys that the file gives, such as "search.basis".
  std::set<std::string> given;
};

/// Reads the detector's part of a TOML file that all programs may share; the table [planner] is
/// left to the planner. Keys and ranges are those of DetectorOptions::visit() and
/// TrackOptions::visit(). Settings that the file leaves out keep their defaults. Spellings of
/// earlier versions, such as planes.least_samples, are accepted too.
/// @param path  empty for the defaults
/// @throws FileError naming line and key if the file is missing or not TOML, if a key is unknown,
///         or if a value has the wrong type or is out of range
DetectorConfig load_detector_config(const std::string& path);

/// Like load_detector_config(), from the text of such a file.
/// @param path  name of the text in errors
DetectorConfig parse_detector_config(std::string_view text, const std::string& path);

/// Returns the options with which to detect: those of the file, or if only spheres are sought those
/// of sphere_preset() except where the file gives others.
DetectorOptions search_options(const DetectorConfig& config);

/// Refuses settings that choose types, where surfaces of all types count.
/// @param given  the keys that the file gives
/// @param path   name of the file in errors
/// @throws FileError naming the key
void refuse_choice_of_types(const std::set<std::string>& given, const std::string& path);

}  // namespace quadrille::io
