#pragma once

#include <functional>

namespace quadrille {

/// Calls task(0) … task(count - 1), each once, on up to `threads` threads. Tasks must not touch
/// each other's results; then the outcome does not depend on the threads. The exception of the
/// task with the lowest number, if any throws, is rethrown.
void parallel_for(int count, int threads, const std::function<void(int)>& task);

}  // namespace quadrille
