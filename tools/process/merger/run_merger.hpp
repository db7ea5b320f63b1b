#pragma once

#include <string>

#include "cli/process_arguments.hpp"

namespace quadrille {

/// What to merge.
struct MergerSettings {
  ProcessArguments process;
  /// Shards publish on CHANNEL_1, CHANNEL_2, …; the merger on CHANNEL.
  std::string channel = "QUADRICS";
  int shards = 2;
  /// How long a result waits for those before it [ms].
  int patience_ms = 500;
};

/// Merges the results of detectors that share a stream, until a stop is requested.
/// @throws std::runtime_error if the bus cannot be used
void run_merger(const MergerSettings& settings);

}  // namespace quadrille
