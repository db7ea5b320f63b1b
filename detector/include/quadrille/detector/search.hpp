#pragma once

#include <cstdint>
#include <vector>

#include "quadrille/detector/family.hpp"
#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/region.hpp"
#include "quadrille/detector/surface_samples.hpp"

namespace quadrille {

struct SearchOptions {
  /// Radii of the neighbourhoods that bases are drawn from, in cells.
  std::vector<double> radii = {5.0, 9.0, 15.0};
  /// Bases per seed and radius.
  int bases = 8;
  /// Voters per basis at most.
  int voters = 160;
  /// Share of a neighbourhood that a hypothesis must explain.
  double least_support = 0.5;
  /// Samples that a candidate has at least.
  int least_samples = 25;
  /// Rounds of growing and refitting.
  int rounds = 5;
};

/// A quadric with the samples that support it.
struct Candidate {
  Quadric Q;
  Family family = Family::kGeneral;
  /// Indices into the samples that it was found on.
  std::vector<int> region;
  /// Root mean square distance of the region [m].
  double rms = 0.0;
};

/// RANSAC over three-point bases with a vote in each (paper, section 4): seeds are drawn from the
/// samples that nothing explains yet; the best hypothesis of a seed is grown and refitted.
/// @param open  per sample, zero to leave it out
std::vector<Candidate> search(const SurfaceSamples& samples, std::vector<char> open,
                              const SearchOptions& options, const InlierTest& inlier,
                              std::uint64_t seed);

}  // namespace quadrille
