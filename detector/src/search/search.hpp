#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadrille/detector/stage_options.hpp"
#include "samples/region.hpp"
#include "samples/surface_samples.hpp"
#include "search/grow.hpp"
#include "search/hypotheses.hpp"

namespace quadrille {

/// Counts of the bases of three points that a search with `hash_triplets` drew.
struct TripletCounts {
  /// Consistent bases that were voted on, and repeated bases that were skipped.
  std::size_t voted = 0, repeated = 0;
};

/// RANSAC over bases of the chosen kind, by default three points with a vote (paper, section 4).
/// Seeds are drawn from the samples that nothing explains yet; the best hypothesis of a seed is
/// grown and refitted.
/// @param open    per sample, zero to leave it out
/// @param counts  receives counts of bases; may be null
std::vector<Candidate> search(const SurfaceSamples& samples, std::vector<char> open,
                              const SearchOptions& options, const InlierTest& inlier,
                              std::uint64_t seed, TripletCounts* counts = nullptr);

}  // namespace quadrille
