#pragma once

#include <string>

#include "lab/bench/speed.hpp"

namespace quadrille {

/// What `quadrille bench --speed` compares with and writes.
struct SpeedFiles {
  /// The baseline; empty for the one that is built into the program.
  std::string baseline;
  /// The file that becomes the next baseline; empty for none.
  std::string store;
};

/// Measures the speed of detection, prints it beside the baseline, and stores it if that is asked
/// for.
/// @throws std::runtime_error if nothing is stored and detection needs too many instructions
void run_speed(bench::SpeedOptions options, const SpeedFiles& files);

}  // namespace quadrille
