#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace quadrille {

/// Returns the unit directions cos t · first + sin t · second for `count` even steps of t from 0 up
/// to, and without, `turn` [rad]; the two vectors are unit vectors at right angles.
std::vector<Eigen::Vector3d> fan(const Eigen::Vector3d& first, const Eigen::Vector3d& second,
                                 int count, double turn);

/// Returns `count` unit directions spread evenly over the half sphere about z, on a golden-angle
/// spiral.
std::vector<Eigen::Vector3d> half_sphere(int count);

/// Returns `count` level unit directions, no two of them opposite; none if `up` is zero.
std::vector<Eigen::Vector3d> level_directions(const Eigen::Vector3d& up, int count);

/// Visits a ranking in 16 passes: every 16th element from the first on, then every 16th from the
/// second on, and so forth. The best elements are much alike, and where one is blocked so are its
/// neighbours; this way, a bounded search meets different ones early.
template <class Iterator, class Visit>
void visit_in_passes(Iterator first, Iterator last, Visit&& visit) {
  constexpr std::ptrdiff_t kPasses = 16;
  for (std::ptrdiff_t pass = 0; pass < kPasses; ++pass) {
    for (std::ptrdiff_t n = pass; n < last - first; n += kPasses) visit(first[n]);
  }
}

}  // namespace quadrille
