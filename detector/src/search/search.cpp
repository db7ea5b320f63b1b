#include "search/search.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "base/marks.hpp"
#include "base/random.hpp"
#include "base/try_ahead.hpp"
#include "samples/flood.hpp"

namespace quadrille {
namespace {

// Least number of voters that must support a hypothesis, even in small neighbourhoods: three agree
// with any basis.
constexpr int kMinSupport = 8;
// A voter decides on λ if its distance from the plane of the basis exceeds this multiple of the
// distance within which it would agree anyway, and this share of the neighbourhood's size.
constexpr double kMinHeightLimits = 2.0, kMinHeight = 0.1;

// Fewer open samples are searched by one thread: to start others, and to fetch the samples for
// them, would take longer.
constexpr std::ptrdiff_t kMinShared = 2500;

/// Marks open samples, while other threads may look. A closed sample stays closed.
class OpenSamples {
 public:
  explicit OpenSamples(const Mask& open) : open_(open.begin(), open.end()) {}

  bool operator[](int i) const { return open_.data()[i].load(std::memory_order_relaxed) != 0; }
  void close(int i) { open_.data()[i].store(0, std::memory_order_relaxed); }

 private:
  std::vector<std::atomic<char>> open_;
};

/// Samples within a ball that are connected to the seed.
/// @param list  buffer
std::vector<int> neighbourhood(const SurfaceSamples& samples, int seed, float radius,
                               const OpenSamples& open, Marks* seen, std::vector<int> list) {
  seen->clear();
  seen->add(seed);
  list.assign(1, seed);
  return flood(samples, std::move(list), [&](int j, int) {
    if (!seen->add(j) || !open[j]) return false;
    return (samples.p[j] - samples.p[seed]).squaredNorm() <= radius * radius;
  });
}

/// The search, whose seeds are steps for take_steps().
class Searcher {
 public:
  /// Tries look at the samples as they are open at present.
  struct State {};
  struct Scratch {
    Marks seen;
    /// The neighbourhood of the seed at hand.
    std::vector<int> around;
  };
  struct Outcome {
    std::vector<Candidate> candidates;
    /// The widest neighbourhood, in which the others lie.
    std::vector<int> around;
  };
  // Most tries end soon, since a seed has few neighbours.
  static constexpr std::size_t kTriesPerThread = 16;

  Searcher(const SurfaceSamples& samples, Mask open, const SearchOptions& options,
           const InlierTest& inlier, std::uint64_t seed, Propose propose, int covers)
      : samples_(samples),
        options_(options),
        inlier_(inlier),
        seed_(seed),
        propose_(std::move(propose)),
        free_(std::move(open)),
        open_(free_),
        missing_(static_cast<std::size_t>(samples.size()), covers),
        order_(static_cast<std::size_t>(samples.size())) {
    std::iota(order_.begin(), order_.end(), 0);
    RandomStream shuffle(seed_, 0);
    for (int i = samples_.size() - 1; i > 0; --i) {
      std::swap(order_[i], order_[shuffle.below(i + 1)]);
    }
  }

  std::vector<Candidate> run(int threads) {
    take_steps(this, threads);
    return std::move(candidates_);
  }

  State state() const { return {}; }
  Scratch scratch() const { return {Marks(static_cast<std::size_t>(samples_.size())), {}}; }
  std::optional<int> first() { return open_from(&first_); }
  std::optional<int> begin_next() {
    next_ = std::max(first_, next_);
    const std::optional<int> seed = open_from(&next_);
    if (seed) ++next_;
    return seed;
  }

  bool is_left(int seed) const { return open_[seed]; }

  /// Grows one candidate from each neighbourhood of a seed that gives one, the largest first. Half
  /// of a large neighbourhood may agree on a quadric that spans two small objects, so smaller ones
  /// are always tried too.
  Outcome attempt(int seed, State /*present*/, Scratch* scratch) const {
    Outcome outcome;
    std::vector<int>& around = scratch->around;
    std::size_t last = 0;
    for (auto radius = options_.radii.rbegin(); radius != options_.radii.rend(); ++radius) {
      around = neighbourhood(samples_, seed, static_cast<float>(*radius) * samples_.cell[seed],
                             open_, &scratch->seen, std::move(around));
      if (radius == options_.radii.rbegin()) outcome.around = around;
      if (static_cast<int>(around.size()) < options_.grow.min_samples / 2) break;
      // A smaller radius that contains the same samples would draw the same bases again.
      if (around.size() == last) continue;
      last = around.size();
      const std::optional<Quadric> hypothesis = best_hypothesis(seed, around);
      if (!hypothesis) continue;
      std::optional<Candidate> grown =
          grow(samples_, *hypothesis, around, free_, inlier_, options_.grow, &scratch->seen);
      if (grown) outcome.candidates.push_back(std::move(*grown));
    }
    return outcome;
  }

  /// A neighbourhood ends at samples that are closed, and these stay so. It is the same as long as
  /// none of its own samples is closed.
  bool holds(int /*seed*/, const Outcome& outcome) const {
    return std::all_of(outcome.around.begin(), outcome.around.end(),
                       [&](int i) { return open_[i]; });
  }

  bool take(int seed, Outcome outcome) {
    open_.close(seed);
    if (outcome.candidates.empty()) {
      for (const int j : samples_.neighbours_of(seed)) open_.close(j);
    }
    for (Candidate& candidate : outcome.candidates) {
      for (const int i : candidate.region) {
        if (--missing_[i] <= 0) open_.close(i);
      }
      candidates_.push_back(std::move(candidate));
    }
    return true;
  }

 private:
  /// The first open seed from a place in their order on, to which the place is moved.
  std::optional<int> open_from(std::size_t* place) const {
    while (*place < order_.size() && !open_[order_[*place]]) ++*place;
    return *place < order_.size() ? std::optional<int>(order_[*place]) : std::nullopt;
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
  const Mask free_;
  /// Samples that too few candidates explain yet and on which no attempt has failed.
  OpenSamples open_;
  /// Per sample, the number of candidates that must still explain it.
  std::vector<int> missing_;
  /// All samples in the order in which they become seeds; the first that may be open; and the first
  /// that was not begun.
  std::vector<int> order_;
  std::size_t first_ = 0, next_ = 0;
  std::vector<Candidate> candidates_;
};

}  // namespace

std::vector<Candidate> search(const SurfaceSamples& samples, Mask open,
                              const SearchOptions& options, const InlierTest& inlier,
                              std::uint64_t seed, Propose given, int covers, int threads) {
  if (!given) {
    given = [&options](const Voters& voters, RandomStream& random) {
      return propose(voters, options.basis, options.bases, random);
    };
  }
  const auto seeds = threads > 1 ? std::count_if(open.begin(), open.end(), std::identity()) : 0;
  if (seeds < kMinShared) threads = 1;
  return Searcher(samples, std::move(open), options, inlier, seed, std::move(given), covers)
      .run(threads);
}

}  // namespace quadrille
