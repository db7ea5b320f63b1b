#include "search/search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/random.hpp"
#include "samples/flood.hpp"
#include "search/bases_needed.hpp"
#include "search/cluster_hypotheses.hpp"

namespace quadrille {
namespace {

// Least number of voters that must support a hypothesis, even in small neighbourhoods: three agree
// with any basis.
constexpr int kMinSupport = 8;
// A fourth point is decisive if its distance from the plane of the others exceeds this multiple of
// the distance within which it would agree anyway, and this share of the neighbourhood's size.
constexpr double kMinHeightLimits = 2.0, kMinHeight = 0.1;

/// Samples within a ball that are connected to the seed.
std::vector<int> neighbourhood(const SurfaceSamples& samples, int seed, float radius,
                               const std::vector<char>& free, std::vector<int>* stamp, int mark) {
  (*stamp)[seed] = mark;
  return flood(samples, {seed}, [&](int j, int) {
    if ((*stamp)[j] == mark || !free[j]) return false;
    (*stamp)[j] = mark;
    return (samples.p[j] - samples.p[seed]).squaredNorm() <= radius * radius;
  });
}

struct Hypothesis {
  /// Symmetric matrix in the coordinates of the voters.
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  int support = 0;
};

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

class Searcher {
 public:
  Searcher(const SurfaceSamples& samples, std::vector<char> open, const SearchOptions& options,
           const InlierTest& inlier, std::uint64_t seed)
      : samples_(samples),
        options_(options),
        inlier_(inlier),
        seed_(seed),
        free_(open),
        open_(std::move(open)),
        stamp_(static_cast<std::size_t>(samples.size()), 0) {}

  std::vector<Candidate> run() {
    std::vector<Candidate> candidates;
    std::vector<int> order(static_cast<std::size_t>(samples_.size()));
    std::iota(order.begin(), order.end(), 0);
    RandomStream shuffle(seed_, 0);
    for (int i = samples_.size() - 1; i > 0; --i) std::swap(order[i], order[shuffle.below(i + 1)]);
    for (const int seed : order) {
      if (!open_[seed]) continue;
      std::vector<Candidate> grown = try_seed(seed);
      if (grown.empty()) {
        retire(seed);
        continue;
      }
      open_[seed] = 0;
      for (Candidate& candidate : grown) {
        for (const int i : candidate.region) open_[i] = 0;
        candidates.push_back(std::move(candidate));
      }
    }
    return candidates;
  }

  TripletCounts counts() const { return {memory_.triplets.size(), memory_.triplets.repeats()}; }

 private:
  void retire(int seed) {
    open_[seed] = 0;
    for (const int j : samples_.neighbours_of(seed)) open_[j] = 0;
  }

  /// Grows one candidate from each neighbourhood of a seed that gives one, the largest first. Half
  /// of a large neighbourhood may agree on a quadric that spans two small objects, so smaller ones
  /// are always tried too.
  std::vector<Candidate> try_seed(int seed) {
    std::vector<Candidate> candidates;
    std::size_t last = 0;
    for (auto radius = options_.radii.rbegin(); radius != options_.radii.rend(); ++radius) {
      const std::vector<int> around =
          neighbourhood(samples_, seed, static_cast<float>(*radius) * samples_.cell[seed], open_,
                        &stamp_, ++mark_);
      if (static_cast<int>(around.size()) < options_.grow.min_samples / 2) break;
      // A smaller radius that contains the same samples would draw the same bases again.
      if (around.size() == last) continue;
      last = around.size();
      const std::optional<Quadric> hypothesis = best_hypothesis(seed, around);
      if (!hypothesis) continue;
      std::optional<Candidate> grown =
          grow(samples_, *hypothesis, around, free_, inlier_, options_.grow);
      if (grown) candidates.push_back(std::move(*grown));
    }
    return candidates;
  }

  /// Number of bases that suffice if the best hypothesis explains `most` of n voters.
  double bases_for(int most, int n) const {
    if (options_.confidence == 0.0) return options_.bases;
    return bases_needed(static_cast<double>(most) / n, basis_size(options_.basis),
                        options_.confidence);
  }

  std::optional<Quadric> best_hypothesis(int seed, const std::vector<int>& around) {
    RandomStream random(seed_, 1 + static_cast<std::uint64_t>(seed));
    const Normalisation local = normalisation_of(samples_, around);
    const std::vector<int> chosen =
        spread_evenly(around, static_cast<std::size_t>(options_.voters));
    const OrientedPointsf voters = fit_points(samples_, chosen, local, options_.voters);
    BasisMemory* const memory = options_.hash_triplets ? &memory_ : nullptr;
    if (memory) memory->sample_of_voter = chosen;
    const float limit = static_cast<float>(
        (inlier_.sigmas * samples_.sigma[seed] + inlier_.cells * samples_.cell[seed]) /
        local.scale);
    const int n = static_cast<int>(voters.size());
    VoteOptions vote_options;
    vote_options.lengths = options_.gradient_lengths;
    vote_options.quantisation = options_.quantisation;
    vote_options.min_height = std::max(kMinHeight, kMinHeightLimits * limit);
    vote_options.min_cosine = inlier_.min_cosine;
    std::vector<Hypothesis> all;
    int most = 0;
    for (int trial = 0; trial < options_.bases && trial < bases_for(most, n); ++trial) {
      for (const Eigen::Matrix4d& Q :
           draw_hypotheses(options_.basis, voters, vote_options, random, memory)) {
        const int support = count_support(voters, Q, limit, static_cast<float>(inlier_.min_cosine));
        all.push_back({Q, support});
        most = std::max(most, support);
      }
    }
    const Hypothesis best =
        options_.clusters.enabled ? best_of_clusters(all, options_.clusters) : best_of(all);
    if (best.support < options_.min_support * n || best.support < kMinSupport) return std::nullopt;
    return local.to_frame(best.Q);
  }

  const SurfaceSamples& samples_;
  const SearchOptions& options_;
  const InlierTest& inlier_;
  const std::uint64_t seed_;
  /// Samples that may support a candidate.
  std::vector<char> free_;
  /// Samples that no candidate explains yet and on which no attempt has failed.
  std::vector<char> open_;
  std::vector<int> stamp_;
  int mark_ = 0;
  BasisMemory memory_;
};

}  // namespace

std::vector<Candidate> search(const SurfaceSamples& samples, std::vector<char> open,
                              const SearchOptions& options, const InlierTest& inlier,
                              std::uint64_t seed, TripletCounts* counts) {
  Searcher searcher(samples, std::move(open), options, inlier, seed);
  std::vector<Candidate> candidates = searcher.run();
  if (counts) *counts = searcher.counts();
  return candidates;
}

}  // namespace quadrille
