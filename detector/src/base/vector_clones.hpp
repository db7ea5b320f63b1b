#pragma once

#include "quadrille/detector/vector_clones.hpp"

namespace quadrille {

/// Sums run in this many strands whatever the width of the vectors, so that results do not depend
/// on it.
inline constexpr int kLanes = 8;

}  // namespace quadrille
