#include "quadrille/detector/plane_claims.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "quadrille/detector/initial_fits.hpp"

namespace quadrille {
namespace {

constexpr double kPartSigmas = 6.0, kPartShare = 0.7, kPartCosine = 0.94;

/// Planes at and around each coarsest cell.
std::vector<std::vector<int>> planes_near(const CellPyramid& pyramid, const SurfaceSamples& coarse,
                                          const std::vector<PlaneRegion>& planes) {
  std::vector<std::vector<int>> near(static_cast<std::size_t>(pyramid.size(kLevels - 1)));
  const auto add = [&](int sample, int plane) {
    std::vector<int>& list = near[coarse.source[sample]];
    if (list.empty() || list.back() != plane) list.push_back(plane);
  };
  for (std::size_t k = 0; k < planes.size(); ++k) {
    for (const int s : planes[k].samples) {
      add(s, static_cast<int>(k));
      for (const int j : coarse.neighbours_of(s)) add(j, static_cast<int>(k));
    }
  }
  return near;
}

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

std::vector<char> cells_off_planes(const CellPyramid& pyramid, const SurfaceSamples& coarse,
                                   const std::vector<PlaneRegion>& planes, double sigmas) {
  const std::vector<std::vector<int>> near = planes_near(pyramid, coarse, planes);
  const int size = pyramid.size(0);
  static_assert(kLevels == 3);
  const std::array<const int*, kLevels - 1> parents = {pyramid.parents(0).data(),
                                                       pyramid.parents(1).data()};
  std::vector<char> keep(static_cast<std::size_t>(size), 1);
  for (int c = 0; c < size; ++c) {
    int above = c;
    for (const int* parent : parents) above = parent[above];
    if (near[above].empty() || pyramid.count(c) == 0) continue;
    const Eigen::Vector4d x = pyramid.mean(c).cast<double>().homogeneous();
    const double limit = sigmas * pyramid.sigma(c);
    for (const int k : near[above]) {
      if (std::abs(planes[k].plane.dot(x)) < limit) keep[c] = 0;
    }
  }
  return keep;
}

Surface plane_surface(const SurfaceSamples& samples, const PlaneRegion& plane) {
  Surface surface;
  surface.region = plane.samples;
  surface.local = normalisation_of(samples, surface.region);
  const FitPoints points = fit_points(samples, surface.region, surface.local, 1000);
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
