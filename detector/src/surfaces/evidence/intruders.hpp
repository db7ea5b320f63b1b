#pragma once

#include <span>

#include "quadrille/detector/quadric.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/evidence/evidence.hpp"
#include "surfaces/evidence/sample_blocks.hpp"

namespace quadrille {

/// Sets the evidence about intruders: samples within the region's box along its principal axes that
/// lie off its quadric. They speak against a quadric but do not refute it, since for instance the
/// inside of a mug lies behind its outside.
/// @param blocks  blocks of the samples
/// @param region   not empty
void add_intruders(const SurfaceSamples& samples, const SampleBlocks& blocks,
                   std::span<const int> region, const Quadric& Q, Evidence* evidence);

}  // namespace quadrille
