#pragma once

#include "cli/process_arguments.hpp"
#include "process/merger/merger.hpp"

namespace quadrille {

struct MergerSettings {
  ProcessArguments process;
  MergerOptions merger;
};

/// Merges the results of detectors that share a stream, until a stop is requested.
/// @throws std::runtime_error if the bus cannot be used, or the connection is lost
void run_merger(const MergerSettings& settings);

}  // namespace quadrille
