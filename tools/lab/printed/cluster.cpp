#include "lab/printed/cluster.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "variants/agglomerate.hpp"
#include "variants/close_distance.hpp"

namespace quadrille::printed {
namespace {

/// A set of samples, one bit each.
using Bits = std::vector<std::uint64_t>;

Bits bits_of(const std::vector<int>& region, int samples) {
  Bits bits(static_cast<std::size_t>(samples + 63) / 64, 0);
  for (const int i : region) bits[static_cast<std::size_t>(i / 64)] |= std::uint64_t{1} << (i % 64);
  return bits;
}

struct Cluster {
  Candidate first;
  /// Unit coefficients in the coordinates that are compared, and the samples on the quadric.
  Vector10d q;
  Bits on;
  int members = 1;
};

/// True if d_far, the share of the samples on either of two quadrics that are not on both, is at
/// most a limit.
bool is_far_below(const Cluster& a, const Cluster& b, double limit) {
  const auto size_a = static_cast<double>(a.first.region.size());
  const auto size_b = static_cast<double>(b.first.region.size());
  // Even if one set lies within the other, they may differ too much.
  if (std::min(size_a, size_b) < (1.0 - limit) * std::max(size_a, size_b)) return false;
  int both = 0;
  for (std::size_t k = 0; k < a.on.size(); ++k) both += std::popcount(a.on[k] & b.on[k]);
  return 1.0 - both / (size_a + size_b - both) <= limit;
}

bool is_close_below(const Cluster& a, const Cluster& b, double max_difference, double limit) {
  // Most pairs differ by more, which is cheap to tell; the sign of q is free.
  const double difference = std::min((a.q - b.q).lpNorm<1>(), (a.q + b.q).lpNorm<1>());
  return difference < max_difference &&
         close_distance(Quadric(a.q).matrix(), Quadric(b.q).matrix(), max_difference) <= limit;
}

bool is_one_surface(const Cluster& a, const Cluster& b) {
  const AgglomerateOptions limits;
  return is_far_below(a, b, limits.max_far) ||
         is_close_below(a, b, limits.max_difference, limits.max_close);
}

}  // namespace

std::vector<Candidate> cluster(std::vector<Candidate> hypotheses, const Normalisation& unit,
                               int samples, int min_members) {
  std::stable_sort(
      hypotheses.begin(), hypotheses.end(),
      [](const Candidate& a, const Candidate& b) { return a.region.size() > b.region.size(); });
  std::vector<Cluster> clusters;
  for (Candidate& hypothesis : hypotheses) {
    const Vector10d q = Quadric(unit.to_local(hypothesis.Q)).normalized().coefficients();
    Bits on = bits_of(hypothesis.region, samples);
    Cluster next{std::move(hypothesis), q, std::move(on)};
    const auto same = std::find_if(clusters.begin(), clusters.end(),
                                   [&](const Cluster& c) { return is_one_surface(next, c); });
    if (same == clusters.end()) {
      clusters.push_back(std::move(next));
    } else {
      ++same->members;
    }
  }
  std::vector<Candidate> kept;
  for (Cluster& c : clusters) {
    if (c.members >= min_members) kept.push_back(std::move(c.first));
  }
  return kept;
}

}  // namespace quadrille::printed
