#pragma once

#include <optional>

#include "quadrille/detector/stage_options.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// The two walls of a body of which both were seen, such as the outer and the inner one of a mug.
struct TwoWalls {
  Surface up, down;
};

/// Tells the walls apart that one quadric was fitted to, and fits each to its own samples, without
/// evidence.
/// @return nullopt if the wall, given its measured thickness, is more likely a thin shell, which is
///   one surface, or thicker than those of vessels. Also if one side has too few samples or no fit.
std::optional<TwoWalls> two_walls(const Surface& surface, const SurfaceSamples& samples,
                                  const AggregateOptions& options);

}  // namespace quadrille
