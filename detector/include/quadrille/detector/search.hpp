#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadrille/detector/grow.hpp"
#include "quadrille/detector/hypotheses.hpp"
#include "quadrille/detector/region.hpp"
#include "quadrille/detector/surface_samples.hpp"

namespace quadrille {

/// Where hypotheses are looked for, and how many.
struct SearchOptions {
  /// How hypotheses are drawn.
  BasisKind basis = BasisKind::kThreePoints;
  Quantisation quantisation = Quantisation::kArctangent;
  /// Radii of the neighbourhoods that bases are drawn from, in cells.
  std::vector<double> radii = {5.0, 9.0, 15.0};
  /// Bases per seed and radius.
  int bases = 5;
  /// Voters per basis at most.
  int voters = 100;
  /// Whether a basis of three points is voted on only once (paper, section 5).
  bool hash_triplets = false;
  /// Share of a neighbourhood that a hypothesis must explain.
  double least_support = 0.5;
  GrowOptions grow;
};

/// Bases of three points that a search with `hash_triplets` met.
struct TripletCounts {
  /// Consistent ones that were voted on, and repeated ones that were not.
  std::size_t voted = 0, repeated = 0;
};

/// RANSAC over bases of the chosen kind, by default three points with a vote (paper, section 4):
/// seeds are drawn from the samples that nothing explains yet; the best hypothesis of a seed is
/// grown and refitted.
/// @param open    per sample, zero to leave it out
/// @param counts  set if given
std::vector<Candidate> search(const SurfaceSamples& samples, std::vector<char> open,
                              const SearchOptions& options, const InlierTest& inlier,
                              std::uint64_t seed, TripletCounts* counts = nullptr);

}  // namespace quadrille
