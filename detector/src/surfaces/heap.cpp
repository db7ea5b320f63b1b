#include "surfaces/heap.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "base/quantile.hpp"
#include "samples/region.hpp"

namespace quadrille {
namespace {

// Cosine of the steepest slope of a heap, 45°. Grain rests at up to 40°, and the cloth of simulated
// scenes at 22° to 39°; the solid things there that bulge from a table are steeper than 58° at
// their foot.
constexpr double kMinCosine = std::numbers::sqrt2 / 2.0;
// Least residual of a heap, as a share of its size: half of the flaws of real objects. The cloth of
// simulated scenes deviates by 2 % from the quadric that fits best.
constexpr double kUneven = 0.5 * kFlawShare;
// Share of the samples that may be steeper or lower by their noise.
constexpr double kOutliers = 0.05;
// Samples within so many standard deviations of their noise above a plane may belong to it, and so
// may the cells that the edge of what lies on it runs through.
constexpr double kFootSigmas = 3.0, kFootCells = 2.0;
// A plane is level if its normal is within 20° of the up direction.
constexpr double kMinLevel = 0.94;
// A plane lies beside a foot if some of its samples lie within so many of their cells. So many
// samples of the foot are looked at.
constexpr float kBesideCells = 3.0f;
constexpr std::size_t kFootSamples = 30;

/// True if the quadric is hardly anywhere steeper against a plane than a heap.
bool is_gentle(const Surface& surface, const SurfaceSamples& samples, const Eigen::Vector3d& n) {
  std::vector<double> cosine;
  for (const int i : surface.region) {
    const Eigen::Vector3d g = surface.Q.gradient(samples.raw[i].cast<double>()).normalized();
    const double towards = g.dot(samples.n[i].cast<double>()) < 0.0 ? -1.0 : 1.0;
    cosine.push_back(towards * g.dot(n));
  }
  return quantile(cosine, kOutliers) > kMinCosine;
}

/// The samples of a surface that are the first above a plane, if there are none below; otherwise
/// none.
std::vector<int> foot_on(const Surface& surface, const SurfaceSamples& samples,
                         const Eigen::Vector4d& plane) {
  const auto height = [&](int i) { return plane.dot(samples.raw[i].cast<double>().homogeneous()); };
  std::vector<double> heights;
  for (const int i : surface.region) heights.push_back(height(i));
  const double lowest = quantile(heights, kOutliers);
  const double first = kFootSigmas * surface.evidence.sigma + kFootCells * surface.evidence.cell;
  std::vector<int> foot;
  if (std::abs(lowest) > first) return foot;
  std::copy_if(surface.region.begin(), surface.region.end(), std::back_inserter(foot),
               [&](int i) { return height(i) < first; });
  return foot;
}

/// True if a plane was seen beside most of a foot.
bool lies_beside(const PlaneRegion& plane, const SurfaceSamples& coarse, std::span<const int> foot,
                 const SurfaceSamples& samples) {
  const std::vector<int> some = spread_evenly(foot, kFootSamples);
  const auto beside = std::count_if(some.begin(), some.end(), [&](int i) {
    return std::any_of(plane.samples.begin(), plane.samples.end(), [&](int k) {
      return (coarse.raw[k] - samples.raw[i]).norm() < kBesideCells * coarse.cell[k];
    });
  });
  return 2 * static_cast<std::size_t>(beside) > some.size();
}

}  // namespace

bool is_heap(const Surface& surface, const SurfaceSamples& samples,
             const std::vector<PlaneRegion>& planes, const SurfaceSamples& coarse,
             const Eigen::Vector3d& up) {
  if (is_flat(surface) || !(surface.evidence.convexity > 0.0)) return false;
  if (surface.rms < kUneven * surface.evidence.size) return false;
  return std::any_of(planes.begin(), planes.end(), [&](const PlaneRegion& plane) {
    const Eigen::Vector3d n = plane.plane.head<3>();
    if (n.dot(up) < kMinLevel || !is_gentle(surface, samples, n)) return false;
    const std::vector<int> foot = foot_on(surface, samples, plane.plane);
    return !foot.empty() && lies_beside(plane, coarse, foot, samples);
  });
}

}  // namespace quadrille
