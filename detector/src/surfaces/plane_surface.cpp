#include "surfaces/plane_surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/initial_plane.hpp"
#include "samples/region.hpp"

namespace quadrille {
namespace {

constexpr double kPartSigmas = 6.0, kPartShare = 0.7, kPartCosine = 0.94;

/// True if most of a flat surface lies on the plane.
bool lies_on(const Surface& flat, const SurfaceSamples& samples, const PlaneRegion& plane) {
  const Eigen::Vector3d n = plane.plane.head<3>();
  if (std::abs(flat.Q.gradient(flat.local.centre).normalized().dot(n)) < kPartCosine) return false;
  const auto on = std::count_if(flat.region.begin(), flat.region.end(), [&](int i) {
    const double d = plane.plane.dot(samples.raw[i].cast<double>().homogeneous());
    return std::abs(d) < kPartSigmas * samples.sigma[i];
  });
  return static_cast<double>(on) > kPartShare * static_cast<double>(flat.region.size());
}

}  // namespace

Surface plane_surface(const SurfaceSamples& samples, const PlaneRegion& plane) {
  Surface surface;
  surface.region = plane.samples;
  surface.local = normalisation_of(samples, surface.region);
  const OrientedPointsf points = fit_points(samples, surface.region, surface.local, 1000);
  PosedQuadric start;
  if (const auto initial = initial_plane(points)) start = *initial;
  if (auto fit = refine(points, Family::kPlane, start, 2)) surface.fit = std::move(*fit);
  surface.Q = surface.local.to_frame(surface.fit.posed.matrix()).normalized();
  surface.rms = surface.local.scale * std::sqrt(surface.fit.rss / surface.fit.points);
  surface.effective_size = 0.25 * static_cast<double>(surface.region.size());
  surface.confidence = 1.0;
  return surface;
}

bool is_part_of(const Surface& flat, const SurfaceSamples& samples,
                const std::vector<PlaneRegion>& planes) {
  return std::any_of(planes.begin(), planes.end(),
                     [&](const PlaneRegion& plane) { return lies_on(flat, samples, plane); });
}

}  // namespace quadrille
