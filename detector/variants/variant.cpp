#include "variants/variant.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "detect_with.hpp"
#include "variants/bases_needed.hpp"
#include "variants/cluster_hypotheses.hpp"
#include "variants/draw_variant.hpp"

namespace quadrille {
namespace {

/// The first hypothesis with the most support; if there is none, one with zero support.
Hypothesis best_of(const std::vector<Hypothesis>& all) {
  Hypothesis best;
  for (const Hypothesis& hypothesis : all) {
    if (hypothesis.support > best.support) best = hypothesis;
  }
  return best;
}

/// The best hypothesis of the cluster whose members have the most support in total (paper,
/// "Hypotheses aggregation").
Hypothesis best_of_clusters(const std::vector<Hypothesis>& all, const ClusterOptions& options) {
  std::vector<Eigen::Matrix4d> quadrics;
  quadrics.reserve(all.size());
  for (const Hypothesis& hypothesis : all) quadrics.push_back(hypothesis.Q);
  Hypothesis best;
  int most = 0;
  for (const std::vector<int>& cluster :
       cluster_hypotheses(quadrics, options.max_difference, options.max_close)) {
    std::vector<Hypothesis> members;
    int support = 0;
    for (const int i : cluster) {
      members.push_back(all[static_cast<std::size_t>(i)]);
      support += members.back().support;
    }
    if (support > most) most = support, best = best_of(members);
  }
  return best;
}

}  // namespace

Propose propose_variant(const Variant& variant, int bases, TripletSet* seen) {
  return [variant, bases, seen](const Voters& given, RandomStream& random) {
    Voters voters = given;
    voters.vote.quantisation = variant.quantisation;
    std::vector<Hypothesis> all;
    double needed = bases;
    for (int trial = 0; trial < needed; ++trial) {
      for (const Eigen::Matrix4d& Q : draw_variant(variant, voters, random, seen)) {
        all.push_back(supported(voters, Q));
      }
      if (variant.confidence == 0.0) continue;
      const double share =
          static_cast<double>(best_of(all).support) / static_cast<double>(voters.points.size());
      needed = std::min<double>(bases,
                                bases_needed(share, basis_size(variant.basis), variant.confidence));
    }
    return variant.clusters ? best_of_clusters(all, *variant.clusters) : best_of(all);
  };
}

DetectionResult detect_variant(const CloudView& cloud, const DetectorOptions& options,
                               const Variant& variant) {
  return detect_with(
      [&](const SampleTree& tree, int level, Mask open, const DetectorOptions& used) {
        TripletSet seen;
        std::vector<Candidate> candidates = find_candidates(
            tree, level, std::move(open), used,
            propose_variant(variant, used.search.bases, variant.hash_triplets ? &seen : nullptr));
        if (!variant.agglomerate) return candidates;
        return agglomerate(std::move(candidates), tree.finest(), used.inlier, *variant.agglomerate);
      },
      cloud, options);
}

}  // namespace quadrille
