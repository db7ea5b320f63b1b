#pragma once

#include <span>

#include "surfaces/surface.hpp"

namespace quadrille {

/// The largest cylinder about the same axis before or behind a surface of revolution, such as the
/// body of a bottle for its shoulder; null if there is none. The other side of its wall is none.
const Surface* sibling_of(const Surface& surface, std::span<const Surface> surfaces,
                          const SurfaceSamples& samples);

}  // namespace quadrille
