#pragma once

#include <string>

#include "quadrille/detector/options.hpp"

namespace quadrille {

/// What the command line asks of the process.
struct DetectorSettings {
  /// Empty: LCM_DEFAULT_URL, or LCM's default.
  std::string lcm_url;
  std::string in_channel = "POINT_CLOUD";
  std::string out_channel = "QUADRICS";
  std::string status_channel = "QUADRILLE_DETECTOR_STATUS";
  /// Log to replay instead of the bus, and log that then takes what is published.
  std::string in_log, out_log;
  /// Copy all events of the replayed log to the other one.
  bool copy_input = false;
  bool verbose = false;
  DetectorOptions detector;
};

}  // namespace quadrille
