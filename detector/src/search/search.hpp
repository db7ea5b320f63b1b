#pragma once

#include <cstdint>
#include <vector>

#include "base/mask.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/region.hpp"
#include "samples/surface_samples.hpp"
#include "search/grow.hpp"
#include "search/hypotheses.hpp"

namespace quadrille {

/// Searches for quadrics by RANSAC (paper, section 4). Seeds are drawn from the samples that too
/// few candidates explain yet, and the hypothesis that a seed's neighbourhood proposes is grown and
/// refitted.
/// @param open     samples to search
/// @param propose  empty for the way that the options select
/// @param covers   number of candidates that explain a sample before it is no longer a seed, at
///   least 1; with more of them the result depends less on the seed
/// @param threads  number of threads, which call `propose` at once; it never changes the result
std::vector<Candidate> search(const SurfaceSamples& samples, Mask open,
                              const SearchOptions& options, const InlierTest& inlier,
                              std::uint64_t seed, Propose propose = {}, int covers = 1,
                              int threads = 1);

}  // namespace quadrille
