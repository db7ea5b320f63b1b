#include "search/search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "base/marks.hpp"
#include "base/random.hpp"
#include "samples/flood.hpp"

namespace quadrille {
namespace {

// Least number of voters that must support a hypothesis, even in small neighbourhoods: three agree
// with any basis.
constexpr int kMinSupport = 8;
// A voter decides on λ if its distance from the plane of the basis exceeds this multiple of the
// distance within which it would agree anyway, and this share of the neighbourhood's size.
constexpr double kMinHeightLimits = 2.0, kMinHeight = 0.1;

/// Samples within a ball that are connected to the seed.
/// @param list  buffer
std::vector<int> neighbourhood(const SurfaceSamples& samples, int seed, float radius,
                               const Mask& free, Marks* seen, std::vector<int> list) {
  seen->clear();
  seen->add(seed);
  list.assign(1, seed);
  return flood(samples, std::move(list), [&](int j, int) {
    if (!seen->add(j) || !free[j]) return false;
    return (samples.p[j] - samples.p[seed]).squaredNorm() <= radius * radius;
  });
}

class Searcher {
 public:
  Searcher(const SurfaceSamples& samples, Mask open, const SearchOptions& options,
           const InlierTest& inlier, std::uint64_t seed, Propose propose, int covers)
      : samples_(samples),
        options_(options),
        inlier_(inlier),
        seed_(seed),
        propose_(std::move(propose)),
        free_(open),
        open_(std::move(open)),
        missing_(static_cast<std::size_t>(samples.size()), covers),
        seen_(static_cast<std::size_t>(samples.size())) {}

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
        for (const int i : candidate.region) {
          if (--missing_[i] <= 0) open_[i] = 0;
        }
        candidates.push_back(std::move(candidate));
      }
    }
    return candidates;
  }

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
      around_ = neighbourhood(samples_, seed, static_cast<float>(*radius) * samples_.cell[seed],
                              open_, &seen_, std::move(around_));
      if (static_cast<int>(around_.size()) < options_.grow.min_samples / 2) break;
      // A smaller radius that contains the same samples would draw the same bases again.
      if (around_.size() == last) continue;
      last = around_.size();
      const std::optional<Quadric> hypothesis = best_hypothesis(seed, around_);
      if (!hypothesis) continue;
      std::optional<Candidate> grown =
          grow(samples_, *hypothesis, around_, free_, inlier_, options_.grow, &seen_);
      if (grown) candidates.push_back(std::move(*grown));
    }
    return candidates;
  }

  Voters voters_of(int seed, const std::vector<int>& around, const Normalisation& local) const {
    Voters voters;
    voters.samples = spread_evenly(around, static_cast<std::size_t>(options_.voters));
    voters.points = fit_points(samples_, voters.samples, local, options_.voters);
    voters.max_distance = static_cast<float>(
        (inlier_.sigmas * samples_.sigma[seed] + inlier_.cells * samples_.cell[seed]) /
        local.scale);
    const double min_height = kMinHeightLimits * static_cast<double>(voters.max_distance);
    voters.vote.min_height = std::max(kMinHeight, min_height);
    voters.vote.min_cosine = inlier_.min_cosine;
    return voters;
  }

  std::optional<Quadric> best_hypothesis(int seed, const std::vector<int>& around) const {
    RandomStream random(seed_, 1 + static_cast<std::uint64_t>(seed));
    const Normalisation local = normalisation_of(samples_, around);
    const Voters voters = voters_of(seed, around, local);
    const Hypothesis best = propose_(voters, random);
    const double min_support = options_.min_support * static_cast<double>(voters.points.size());
    if (best.support < min_support || best.support < kMinSupport) return std::nullopt;
    return local.to_frame(best.Q);
  }

  const SurfaceSamples& samples_;
  const SearchOptions& options_;
  const InlierTest& inlier_;
  const std::uint64_t seed_;
  const Propose propose_;
  /// Samples that may support a candidate.
  Mask free_;
  /// Samples that too few candidates explain yet and on which no attempt has failed.
  Mask open_;
  /// Per sample, the number of candidates that must still explain it.
  std::vector<int> missing_;
  Marks seen_;
  /// The neighbourhood of the seed at hand.
  std::vector<int> around_;
};

}  // namespace

std::vector<Candidate> search(const SurfaceSamples& samples, Mask open,
                              const SearchOptions& options, const InlierTest& inlier,
                              std::uint64_t seed, Propose given, int covers) {
  if (!given) {
    given = [&options](const Voters& voters, RandomStream& random) {
      return propose(voters, options.basis, options.bases, random);
    };
  }
  return Searcher(samples, std::move(open), options, inlier, seed, std::move(given), covers).run();
}

}  // namespace quadrille
