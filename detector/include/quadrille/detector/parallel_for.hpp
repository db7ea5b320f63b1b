#pragma once

#include <functional>

#include "quadrille/detector/export.hpp"

namespace quadrille {

/// Calls task(0) … task(count - 1) once each on up to `threads` threads. The outcome does not
/// depend on the threads if tasks do not touch each other's results. If tasks throw, the exception
/// of the one with the lowest number is rethrown.
QUADRILLE_EXPORT void parallel_for(int count, int threads, const std::function<void(int)>& task);

}  // namespace quadrille
