#pragma once

#include <functional>

#include "quadrille/detector/export.hpp"

namespace quadrille {

/// Calls task(0) … task(count - 1) once each on up to `threads` threads. The outcome does not
/// depend on the threads if tasks do not touch each other's results. The calling thread works too,
/// and is the only one if `threads` is below 2. If tasks throw, all others are run all the same,
/// and the exception of the one with the lowest number is rethrown.
/// @throws std::system_error if no further thread can be started
QUADRILLE_EXPORT void parallel_for(int count, int threads, const std::function<void(int)>& task);

}  // namespace quadrille
