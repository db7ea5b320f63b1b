#include "surfaces/heap.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "base/quantile.hpp"

namespace quadrille {
namespace {

// The steepest slope at which loose things rest, tan 45°: their angle of repose.
const double kReposeCosine = std::numbers::sqrt2 / 2.0;
// Share of the samples that may be steeper or lower by their noise.
constexpr double kOutliers = 0.05;
// Samples within so many standard deviations of their noise above a plane may belong to it, and so
// may the cells that the edge of what lies on it runs through.
constexpr double kFootSigmas = 3.0, kFootCells = 2.0;

/// True if nearly all samples lie above a plane, and the lowest ones are the first above it.
bool reaches_down_to(const Surface& surface, const SurfaceSamples& samples,
                     const PlaneRegion& plane) {
  std::vector<double> height;
  for (const int i : surface.region) {
    height.push_back(plane.plane.dot(samples.raw[i].cast<double>().homogeneous()));
  }
  const Evidence& evidence = surface.evidence;
  const double first = kFootSigmas * evidence.sigma + kFootCells * evidence.cell;
  return std::abs(quantile(height, kOutliers)) < first;
}

/// True if the quadric is hardly anywhere steeper against a plane than loose things rest.
bool is_gentle(const Surface& surface, const SurfaceSamples& samples, const PlaneRegion& plane) {
  std::vector<double> cosine;
  for (const int i : surface.region) {
    const Eigen::Vector3d n = surface.Q.gradient(samples.raw[i].cast<double>()).normalized();
    const double towards = n.dot(samples.n[i].cast<double>()) < 0.0 ? -1.0 : 1.0;
    cosine.push_back(towards * n.dot(plane.plane.head<3>()));
  }
  return quantile(cosine, kOutliers) > kReposeCosine;
}

}  // namespace

bool is_heap(const Surface& surface, const SurfaceSamples& samples,
             const std::vector<PlaneRegion>& planes) {
  if (is_flat(surface) || surface.evidence.convexity <= 0.0) return false;
  return std::any_of(planes.begin(), planes.end(), [&](const PlaneRegion& plane) {
    return is_gentle(surface, samples, plane) && reaches_down_to(surface, samples, plane);
  });
}

}  // namespace quadrille
