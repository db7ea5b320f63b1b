#pragma once

#include <vector>

#include "base/mask.hpp"
#include "boxes/face.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Finds flat patches among samples that neither planes nor curved surfaces explain. They may be
/// faces of small boxes: rounded edges bend them too much for a plane that is sure, so they only
/// tell where a face is sought.
/// @param free  samples to use
std::vector<FlatPatch> find_flat_patches(const SurfaceSamples& samples, const PlaneOptions& options,
                                         const Mask& free);

}  // namespace quadrille
