#include "surfaces/evidence/axis_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fit/posed_quadric.hpp"
#include "samples/region.hpp"
#include "search/axes/normal_line.hpp"

namespace quadrille {
namespace {

// The neighbourhood reaches so far beyond the region, in its largest radii.
constexpr float kReach = 1.5f;
// A wide surface that hardly bends has its axis far away. Radii are counted up to this multiple of
// the region's size.
constexpr double kMaxRadius = 3.0;

}  // namespace

AxisNeighbours axis_neighbours(const SurfaceSamples& samples, const SampleBlocks& blocks,
                               std::span<const int> region, const Axis& axis) {
  const Normalisation local = normalisation_of(samples, region);
  const Eigen::Vector3d foot =
      axis.point + axis.direction * axis.direction.dot(local.centre - axis.point);
  const Eigen::Isometry3f X_AC = pose_along(foot, axis.direction).inverse().cast<float>();
  std::vector<char> inside(static_cast<std::size_t>(samples.size()), 0);
  float radius = 0, low = 0, high = 0;
  for (const int i : region) {
    inside[i] = 1;
    const Eigen::Vector3f x = X_AC * samples.raw[i];
    radius = std::max(radius, x.head<2>().norm());
    low = std::min(low, x.z()), high = std::max(high, x.z());
  }
  radius = kReach * std::min(radius, static_cast<float>(kMaxRadius * local.scale));
  low -= radius, high += radius;
  int meet = 0, miss = 0;
  const Eigen::AlignedBox3f box(Eigen::Vector3f(-radius, -radius, low),
                                Eigen::Vector3f(radius, radius, high));
  for (const int i : blocks.in_box(X_AC, box)) {
    if (inside[i]) continue;
    const Eigen::Vector3f x = X_AC * samples.raw[i];
    if (x.z() < low || x.z() > high || x.head<2>().norm() > radius) continue;
    const NormalLine line(x, X_AC.linear() * samples.n[i]);
    if (!line.has_direction()) continue;
    ++(line.meets_axis(samples.cell[i]) ? meet : miss);
  }
  const double size = static_cast<double>(region.size());
  return {meet / size, miss / size};
}

}  // namespace quadrille
