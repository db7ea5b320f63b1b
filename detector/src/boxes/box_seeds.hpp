#pragma once

#include <vector>

#include "base/mask.hpp"
#include "boxes/face.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Patches at right angles to each other, one for each side of a thing that may be a box.
using BoxSeed = std::vector<FlatPatch>;

/// Seeds of boxes in the convex pieces of some samples. The normals of a piece gather about three
/// axes at right angles, though its faces may bulge and its edges be rounded so much that no face
/// is found alone.
/// @param free  samples to use
std::vector<BoxSeed> find_box_seeds(const SurfaceSamples& samples, const Mask& free);

}  // namespace quadrille
