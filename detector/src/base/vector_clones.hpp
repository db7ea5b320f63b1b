#pragma once

#include "quadrille/detector/vector_clones.hpp"

// Keeps a short loop within another one until it can become vector instructions; GCC would unroll
// it first, and it seldom makes vectors of an unrolled loop.
#if defined(__GNUC__) && !defined(__clang__)
#define QUADRILLE_KEEP_LOOP _Pragma("GCC unroll 1")
#else
#define QUADRILLE_KEEP_LOOP
#endif

namespace quadrille {

/// Sums run in this many lanes whatever the width of the vectors, so that results do not depend
/// on it.
inline constexpr int kLanes = 8;

}  // namespace quadrille
