#include "lab/printed/cluster.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "variants/agglomerate.hpp"
#include "variants/close_distance.hpp"
#include "variants/cluster_greedily.hpp"

namespace quadrille::printed {
namespace {

/// A set of samples, one bit each.
using Bits = std::vector<std::uint64_t>;

Bits bits_of(const std::vector<int>& region, int samples) {
  Bits bits(static_cast<std::size_t>(samples + 63) / 64, 0);
  for (const int i : region) bits[static_cast<std::size_t>(i / 64)] |= std::uint64_t{1} << (i % 64);
  return bits;
}

/// What of a hypothesis is compared.
struct Traits {
  /// Unit coefficients in the coordinates that are compared, and the samples on the quadric.
  Vector10d q;
  Bits on;
};
using Cluster = GreedyCluster<Traits>;

/// True if d_far, the share of the samples on either of two quadrics that are not on both, is at
/// most a limit.
bool is_far_below(const Cluster& a, const Cluster& b, double limit) {
  const auto size_a = static_cast<double>(a.first.region.size());
  const auto size_b = static_cast<double>(b.first.region.size());
  // Even if one set lies within the other, they may differ too much.
  if (std::min(size_a, size_b) < (1.0 - limit) * std::max(size_a, size_b)) return false;
  const Bits &on_a = a.traits.on, &on_b = b.traits.on;
  int both = 0;
  for (std::size_t k = 0; k < on_a.size(); ++k) both += std::popcount(on_a[k] & on_b[k]);
  return 1.0 - both / (size_a + size_b - both) <= limit;
}

bool is_close_below(const Vector10d& a, const Vector10d& b, double max_difference, double limit) {
  // Most pairs differ by more, which is cheap to tell; the sign of q is free.
  const double difference = std::min((a - b).lpNorm<1>(), (a + b).lpNorm<1>());
  return difference < max_difference &&
         close_distance(Quadric(a).matrix(), Quadric(b).matrix(), max_difference) <= limit;
}

bool is_one_surface(const Cluster& a, const Cluster& b) {
  const AgglomerateOptions limits;
  return is_far_below(a, b, limits.max_far) ||
         is_close_below(a.traits.q, b.traits.q, limits.max_difference, limits.max_close);
}

}  // namespace

std::vector<Candidate> cluster(std::vector<Candidate> hypotheses, const Normalisation& unit,
                               int samples, int min_members) {
  const auto traits_of = [&](const Candidate& hypothesis) {
    return Traits{Quadric(unit.to_local(hypothesis.Q)).normalized().coefficients(),
                  bits_of(hypothesis.region, samples)};
  };
  std::vector<Candidate> kept;
  for (Cluster& c : cluster_greedily(std::move(hypotheses), traits_of, is_one_surface)) {
    if (c.members >= min_members) kept.push_back(std::move(c.first));
  }
  return kept;
}

}  // namespace quadrille::printed
