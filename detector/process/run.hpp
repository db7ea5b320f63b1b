#pragma once

#include "settings.hpp"

namespace quadrille {

/// Works on the bus until a stop is requested.
void run_on_bus(const DetectorSettings& settings);

/// Works through a log.
/// @throws std::runtime_error if a log cannot be used, or the detection failed on a cloud
void run_on_log(const DetectorSettings& settings);

}  // namespace quadrille
