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

/// The support above which a connected piece of samples may be one lump or several; nullptr if it
/// is too small, or there is none.
/// @param alone  true if no surface that was found touches the piece, so that none can hide its
///               foot
const Support* lump_support(const SurfaceSamples& samples, const std::vector<int>& piece,
                            const std::vector<Support>& supports, bool alone);

/// The samples of a piece that rise from its support. The others are noise that lies around things,
/// and would connect them.
Mask above_support(const SurfaceSamples& samples, const std::vector<int>& piece,
                   const Support& support);

/// A piece of samples as a body above a support, with the smallest upright box around it; nullopt
/// if it is too small, or too little rises from the support. Its id and number of points stay
/// unset.
std::optional<SceneBody> lump_of(const SurfaceSamples& samples, const std::vector<int>& piece,
                                 const Support& support);

}  // namespace quadrille
