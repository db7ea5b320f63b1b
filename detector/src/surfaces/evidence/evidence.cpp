#include "surfaces/evidence/evidence.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <memory>

#include "base/quantile.hpp"
#include "samples/inliers.hpp"
#include "samples/plane_sums.hpp"
#include "surfaces/evidence/neighbour_sums.hpp"
#include "surfaces/evidence/smooth_parts.hpp"
#include "surfaces/evidence/two_planes.hpp"

namespace quadrille {
namespace {

// Number of neighbours of a sample that has them on all sides.
constexpr int kAllNeighbours = 8;
// Added to sums of squared distances [m²], so that their ratio exists even for exact fits.
constexpr double kMinSquare = 1e-12;
// Least size [m], so that the logarithm of that of one sample exists.
constexpr double kMinSize = 1e-6;

/// The neighbour of j farthest in the direction of a step that leads to j; -1 if none lies that
/// way.
int next_along(const SurfaceSamples& samples, int j, const Eigen::Vector3f& step) {
  int next = -1;
  // The neighbour must be at least half a step farther.
  float max_along = 0.5f * step.squaredNorm();
  for (const int k : samples.neighbours_of(j)) {
    const float along = (samples.raw[k] - samples.raw[j]).dot(step);
    if (along > max_along) max_along = along, next = k;
  }
  return next;
}

/// Finds the region's border, and sets the evidence about it. Windows of neighbouring normals
/// overlap, so even a crease looks smooth from one sample to the next; therefore the normals are
/// compared across two steps.
RegionBorder walk_neighbours(const SurfaceSamples& samples, std::span<const int> region,
                             const std::vector<char>& inside, Evidence* e) {
  RegionBorder border;
  double open = 0, edge = 0, interior = 0;
  for (const int i : region) {
    int within = 0;
    const std::span<const int> neighbours = samples.neighbours_of(i);
    for (const int j : neighbours) {
      if (inside[j]) {
        ++within;
        continue;
      }
      const int next = next_along(samples, j, samples.raw[j] - samples.raw[i]);
      if (next >= 0 && !inside[next] && samples.n[next].dot(samples.n[i]) > kMinSmoothCosine) {
        border.beyond.push_back(next);
      }
    }
    border.places += kAllNeighbours - within;
    open += within < static_cast<int>(neighbours.size());
    edge += static_cast<int>(neighbours.size()) < kAllNeighbours;
    interior += within == kAllNeighbours;
  }
  const double n = static_cast<double>(region.size());
  e->open_border = open / n;
  e->depth_edge = edge / n;
  e->interior = interior / n;
  return border;
}

/// Sets the evidence about how far the positions spread.
/// @param square  sum of the squared distances from the quadric [m²]
void compare_with_plane(const SurfaceSamples& samples, std::span<const int> region, double square,
                        Evidence* e) {
  const Eigen::Vector3d origin = samples.raw[region[0]].cast<double>();
  PlaneSums sums;
  for (const int i : region) sums.add(samples.raw[i].cast<double>() - origin);
  const Eigen::Vector3d mean = sums.sum / sums.n;
  const Eigen::Matrix3d covariance = sums.squares() / sums.n - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(covariance, Eigen::EigenvaluesOnly);
  // The mean squares along the principal axes; the least is the distance from the best plane.
  const Eigen::Vector3d v = eigen.eigenvalues().cwiseMax(0.0);
  e->size = std::max(kMinSize, std::sqrt(v.sum()));
  e->thickness = std::sqrt(v[0] / std::max(v[2], kMinSquare));
  e->one_plane = std::log((v[0] + kMinSquare) * sums.n / square);
}

/// Sets the evidence about the correlation of neighbouring distances.
/// @param square  mean square of the distances [m²]
void compare_neighbours(const SurfaceSamples& samples, std::span<const int> region,
                        const std::vector<char>& inside, const std::vector<float>& distance,
                        double square, Evidence* e) {
  // Only the region's distances are set and read; clearing all would take longer than the sums.
  const auto distance_of =
      std::make_unique_for_overwrite<float[]>(static_cast<std::size_t>(samples.size()));
  for (std::size_t k = 0; k < region.size(); ++k) distance_of[region[k]] = distance[k];
  const NeighbourSums sums = sum_neighbours(samples, region, inside, distance_of.get());
  e->residual = std::sqrt(square) / e->sigma;
  if (sums.pairs == 0) return;
  e->roughness = std::sqrt(0.5 * sums.difference / sums.pairs) / e->sigma;
  e->correlation = sums.product / sums.pairs / square;
}

/// Sum of the principal curvatures, averaged over the samples [1/m]; positive if the quadric bulges
/// towards the sensor.
double mean_curvature(const SurfaceSamples& samples, std::span<const int> region,
                      const Eigen::Matrix4f& Q) {
  const Eigen::Matrix3f H = Q.topLeftCorner<3, 3>();
  double curvature = 0;
  for (const int i : region) {
    const Eigen::Vector3f h = (Q * samples.raw[i].homogeneous()).head<3>();
    const float slope = h.norm();
    const Eigen::Vector3f g = h / slope;
    const float cosine = g.dot(samples.n[i]);
    const float bend = (H.trace() - g.dot(H * g)) / slope;
    curvature += static_cast<double>(cosine > 0 ? bend : -bend);
  }
  return curvature / static_cast<double>(region.size());
}

}  // namespace

double normal_spread(const SurfaceSamples& samples, std::span<const int> region) {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const int i : region) mean += samples.n[i];
  mean.normalize();
  std::vector<float> cosine;
  for (const int i : region) cosine.push_back(samples.n[i].dot(mean));
  return std::acos(std::clamp(nth_smallest(cosine, cosine.size() / 10), -1.0f, 1.0f));
}

double RegionBorder::smooth_share(const Mask& free) const {
  const auto smooth =
      free.empty() ? static_cast<std::ptrdiff_t>(beyond.size())
                   : std::count_if(beyond.begin(), beyond.end(), [&](int i) { return free[i]; });
  return static_cast<double>(smooth) / std::max(1.0, places);
}

Evidence collect_evidence(const SurfaceSamples& samples, std::span<const int> region,
                          const Quadric& quadric, RegionBorder* border) {
  Evidence e;
  const double n = static_cast<double>(region.size());
  double square = kMinSquare * n;
  const Eigen::Matrix4f Q = quadric.normalized().matrix().cast<float>();
  std::vector<char> inside(static_cast<std::size_t>(samples.size()), 0);
  std::vector<float> distance(region.size());
  for (std::size_t k = 0; k < region.size(); ++k) {
    const int i = region[k];
    const float d = distance[k] = distance_to(Q, samples.raw[i]);
    square += static_cast<double>(d * d);
    inside[i] = 1;
  }
  e.log_count = std::log(n);
  for (const int i : region) e.sigma += samples.sigma[i] / n, e.cell += samples.cell[i] / n;
  e.common_noise = samples.common_noise;
  e.spread = normal_spread(samples, region);
  e.two_planes = std::log((two_planes_rss(samples, region) + kMinSquare * n) / square);
  compare_with_plane(samples, region, square, &e);
  compare_neighbours(samples, region, inside, distance, square / n, &e);
  e.convexity = mean_curvature(samples, region, Q) * e.size;
  *border = walk_neighbours(samples, region, inside, &e);
  return e;
}

Evidence collect_evidence(const SurfaceSamples& samples, std::span<const int> region,
                          const Quadric& quadric, const Mask& free) {
  RegionBorder border;
  Evidence e = collect_evidence(samples, region, quadric, &border);
  e.smooth_border = border.smooth_share(free);
  return e;
}

}  // namespace quadrille
