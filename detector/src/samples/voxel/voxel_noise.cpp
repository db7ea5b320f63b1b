#include "samples/voxel/voxel_noise.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/quantile.hpp"
#include "samples/height_fit.hpp"
#include "samples/plane_moments.hpp"
#include "samples/voxel/voxel_finder.hpp"

namespace quadrille {
namespace {

// Noise assumed if it cannot be measured, which is typical of depth cameras [m].
constexpr float kDefaultSigma = 1e-3f;
// Fewer points leave hardly a residual to six coefficients.
constexpr std::size_t kMinPatchPoints = 18;
// Least radius of a patch in voxels, so that it holds that many points.
constexpr float kMinRadiusVoxels = 3.0f;

/// Residual of a quadratic height over the plane of the points [m]; negative if there are too few.
/// @param points  relative to a point near them [m]
float quadratic_residual(const std::vector<Eigen::Vector3f>& points, float radius) {
  PlaneMoments sums;
  for (const Eigen::Vector3f& p : points) sums.add(p);
  const auto plane = sums.solve();
  if (points.size() < kMinPatchPoints || !plane) return -1.0f;
  const Eigen::Vector3f e1 = plane->normal.unitOrthogonal(), e2 = plane->normal.cross(e1);
  HeightFit fit;
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3f d = (p - plane->mean) / radius;
    fit.add(d.dot(e1), d.dot(e2), d.dot(plane->normal));
  }
  const double rss = fit.rss(fit.factor().solve(fit.b));
  return radius * static_cast<float>(std::sqrt(rss / static_cast<double>(points.size() - 6)));
}

}  // namespace

float measure_voxel_noise(const VoxelGrid& grid, const NoiseOptions& options) {
  const float radius = std::max(static_cast<float>(options.radius), kMinRadiusVoxels * grid.edge());
  std::vector<float> residual;
  std::vector<Eigen::Vector3f> patch;
  VoxelFinder finder(grid, radius);
  const int stride = std::max(1, grid.size() / options.patches);
  for (int v = 0; v < grid.size(); v += stride) {
    const Eigen::Vector3f& p = grid.mean()[v];
    patch.clear();
    for (const int other : finder.within(p)) patch.push_back(grid.mean()[other] - p);
    const float r = quadratic_residual(patch, radius);
    if (r >= 0) residual.push_back(r);
  }
  if (residual.size() < kMinResiduals) return kDefaultSigma;
  return std::max(kMinSigma, quantile(residual, options.quantile));
}

}  // namespace quadrille
