#pragma once

#include <string>

#include "cli/process_arguments.hpp"
#include "quadrille/detector/options.hpp"

namespace quadrille {

/// What the command line asks of the process.
struct DetectorSettings {
  ProcessArguments process;
  std::string in_channel = "POINT_CLOUD";
  std::string out_channel = "QUADRICS";
  std::string status_channel = "QUADRILLE_DETECTOR_STATUS";
  DetectorOptions detector;
};

}  // namespace quadrille
