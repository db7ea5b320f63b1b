#include "surfaces/evidence/two_planes.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "samples/plane_sums.hpp"
#include "samples/region.hpp"

namespace quadrille {
namespace {

// Rounds of 2-means and of Lloyd's algorithm, after which few samples still change sides.
constexpr int kNormalRounds = 5, kDistanceRounds = 4;
// More samples do not improve the planes.
constexpr std::size_t kMaxSamples = 400;
// Used as the plane of too few samples; it is so far away that no sample is nearer to it than to
// the other plane.
const Eigen::Vector4d kFarPlane(0, 0, 0, 1e3);

/// The plane through positions near the origin, where subtracting the mean from the sums loses no
/// accuracy.
Eigen::Vector4d plane_of(const PlaneSums& sums) {
  if (sums.n < 3) return kFarPlane;
  const Eigen::Vector3d m = min_spread_direction(
      sums.squares() / sums.n - sums.sum * sums.sum.transpose() / (sums.n * sums.n));
  return {m.x(), m.y(), m.z(), -m.dot(sums.sum) / sums.n};
}

/// The samples' positions relative to an origin, in homogeneous coordinates.
std::vector<Eigen::Vector4d> positions_of(const SurfaceSamples& samples,
                                          std::span<const int> region,
                                          const Eigen::Vector3d& origin) {
  std::vector<Eigen::Vector4d> positions;
  positions.reserve(region.size());
  for (const int i : region) {
    positions.emplace_back((samples.raw[i].cast<double>() - origin).homogeneous());
  }
  return positions;
}

/// The normal that differs most from a direction.
Eigen::Vector3f farthest_normal(const SurfaceSamples& samples, std::span<const int> region,
                                const Eigen::Vector3f& from) {
  int best = region[0];
  for (const int i : region) {
    if (samples.n[i].dot(from) < samples.n[best].dot(from)) best = i;
  }
  return samples.n[best];
}

/// Divides a region in two by its normals, with 2-means that starts from two very different
/// normals.
std::vector<char> part_by_normals(const SurfaceSamples& samples, std::span<const int> region) {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const int i : region) mean += samples.n[i];
  std::array<Eigen::Vector3f, 2> centre;
  centre[0] = farthest_normal(samples, region, mean);
  centre[1] = farthest_normal(samples, region, centre[0]);
  std::vector<char> side(region.size(), 0);
  for (int round = 0; round < kNormalRounds; ++round) {
    std::array<Eigen::Vector3f, 2> sum = {Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
    for (std::size_t r = 0; r < region.size(); ++r) {
      const Eigen::Vector3f& n = samples.n[region[r]];
      side[r] = n.dot(centre[1]) > n.dot(centre[0]);
      sum[static_cast<std::size_t>(side[r])] += n;
    }
    for (int c = 0; c < 2; ++c) {
      if (sum[c].norm() > 0) centre[c] = sum[c].normalized();
    }
  }
  return side;
}

}  // namespace

double two_planes_rss(const SurfaceSamples& samples, std::span<const int> region) {
  const std::vector<int> some = spread_evenly(region, kMaxSamples);
  std::vector<char> side = part_by_normals(samples, some);
  // Near an edge the smoothed normals lie between those of the faces, so from here on the distance
  // decides.
  const std::vector<Eigen::Vector4d> positions =
      positions_of(samples, some, samples.raw[some[0]].cast<double>());
  double rss = 0;
  for (int round = 0; round < kDistanceRounds; ++round) {
    std::array<PlaneSums, 2> sides;
    for (std::size_t r = 0; r < some.size(); ++r) {
      sides[static_cast<std::size_t>(side[r])].add(positions[r].head<3>());
    }
    const Eigen::Vector4d first = plane_of(sides[0]), second = plane_of(sides[1]);
    rss = 0;
    for (std::size_t r = 0; r < some.size(); ++r) {
      const double a = std::abs(first.dot(positions[r])), b = std::abs(second.dot(positions[r]));
      side[r] = b < a;
      rss += std::min(a * a, b * b);
    }
  }
  return rss * static_cast<double>(region.size()) / static_cast<double>(some.size());
}

}  // namespace quadrille
