#include "variants/cluster_greedily.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("candidates join the first cluster whose largest member is the same", "[agglomerate]") {
  std::vector<Candidate> candidates(5);
  const std::vector<double> places = {0.0, 0.9, 1.8, 5.0, 0.1};
  const std::vector<std::size_t> sizes = {3, 9, 4, 4, 1};
  for (std::size_t n = 0; n < candidates.size(); ++n) {
    candidates[n].region.resize(sizes[n], 0);
    candidates[n].rms = places[n];
  }
  using Cluster = GreedyCluster<double>;
  const auto clusters = cluster_greedily(
      candidates, [](const Candidate& c) { return c.rms; },
      [](const Cluster& a, const Cluster& b) { return std::abs(a.traits - b.traits) < 1.0; });
  REQUIRE(clusters.size() == 2);
  // The largest takes those on both its sides, though they lie apart from each other.
  CHECK(clusters[0].first.region.size() == 9);
  CHECK(clusters[0].members == 4);
  CHECK(clusters[1].traits == 5.0);
  CHECK(clusters[1].members == 1);
  CHECK(cluster_greedily(
            std::vector<Candidate>{}, [](const Candidate& c) { return c.rms; },
            [](const Cluster&, const Cluster&) { return true; })
            .empty());
}
