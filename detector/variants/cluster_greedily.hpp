#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "search/candidate.hpp"

namespace quadrille {

/// Candidates that are taken for one surface.
template <class Traits>
struct GreedyCluster {
  /// The one with the largest region, and what of it is compared.
  Candidate first;
  Traits traits;
  int members = 1;
};

/// Clusters candidates greedily (paper, "Hypotheses aggregation"), those with the largest regions
/// first. Each joins the first cluster whose first member is the same surface, or begins another.
/// @param traits_of  returns what of a candidate is compared
/// @param is_same    tells whether a cluster of one, and another cluster, are the same surface
/// @return the clusters, those with the largest regions first
template <class TraitsOf, class IsSame>
auto cluster_greedily(std::vector<Candidate> candidates, const TraitsOf& traits_of,
                      const IsSame& is_same) {
  using Cluster = GreedyCluster<decltype(traits_of(candidates.front()))>;
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.region.size() > b.region.size(); });
  std::vector<Cluster> clusters;
  for (Candidate& candidate : candidates) {
    auto traits = traits_of(candidate);
    Cluster next{std::move(candidate), std::move(traits)};
    const auto same = std::find_if(clusters.begin(), clusters.end(),
                                   [&](const Cluster& c) { return is_same(next, c); });
    if (same == clusters.end()) {
      clusters.push_back(std::move(next));
    } else {
      ++same->members;
    }
  }
  return clusters;
}

}  // namespace quadrille
