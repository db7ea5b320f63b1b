#pragma once

#include <optional>
#include <vector>

#include "base/mask.hpp"
#include "bodies/support.hpp"
#include "quadrille/detector/body.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Samples that lie on no detection and in no box.
/// @param owner  for each sample the id of the detection on which it lies, 0 for none
Mask open_samples(const SurfaceSamples& samples, const std::vector<int>& owner,
                  const std::vector<Box>& boxes);

/// A piece of samples as a body above a support, with the smallest upright box around it; nullopt
/// if it does not stand on a support, or too little rises from it. Its id and number of points stay
/// unset.
/// @param alone  true if nothing touches the piece, so that nothing can hide its foot
std::optional<SceneBody> lump_of(const SurfaceSamples& samples, const std::vector<int>& piece,
                                 const std::vector<Support>& supports, bool alone);

}  // namespace quadrille
