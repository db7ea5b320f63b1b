#pragma once

#include <set>
#include <string>

#include "quadrille/detector/options.hpp"
#include "quadrille/detector/tracker.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille::io {

/// What a configuration file sets.
struct Settings {
  DetectorOptions detector;
  TrackOptions track;
  PlanOptions planner;
  /// The keys that it gives, such as "search.basis".
  std::set<std::string> given;
};

/// Reads the settings of a TOML file, which all programs share: each takes its own part of them.
/// The detector's keys are those of visit_options() and visit_track_options(); the planner's stand
/// in the table [planner]: unknown, resolution [m], friction, approach [m], pad_margin [m],
/// baseline [m], min_wall and max_wall [m], max_grasps. What the file leaves out keeps its
/// default.
/// @throws FileError naming line and key if the file is missing or no TOML, if a key is unknown, or
///         if a value has the wrong type or is out of range
Settings load_settings(const std::string& path);

/// The detector's defaults as a commented TOML file, from which load_settings reads them back.
std::string default_detector_config();

}  // namespace quadrille::io
