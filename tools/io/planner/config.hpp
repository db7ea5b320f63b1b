#pragma once

#include <string>
#include <string_view>

#include "io/settings/config.hpp"
#include "quadrille/grasping/plan_options.hpp"

namespace quadrille::io {

/// The settings of all programs from a file.
struct Config : DetectorConfig {
  PlanOptions planner;
};

/// Reads a file of settings as load_detector_config() does, with the table [planner], whose keys
/// and ranges are those of PlanOptions::visit().
/// @param path  empty for the defaults
/// @throws FileError as load_detector_config() does
Config load_config(const std::string& path);

/// Like load_config(), from the text of such a file.
/// @param path  name of the text in errors
Config parse_config(std::string_view text, const std::string& path);

/// Returns a file that load_config() reads back to the same settings, with unit, range, default and
/// meaning of each as a comment.
std::string to_toml(const Config& config);

}  // namespace quadrille::io
