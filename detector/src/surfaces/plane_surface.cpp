#include "surfaces/plane_surface.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "fit/closed_form/initial_plane.hpp"
#include "samples/region.hpp"
#include "surfaces/evidence/sample_blocks.hpp"
#include "surfaces/surface_fit.hpp"
#include "surfaces/weigh.hpp"

namespace quadrille {
namespace {

// A flat strip is part of a plane if more than this share of it lies within this many sigma, twice
// what the plane's own samples may deviate, and if it is parallel within 20°.
constexpr double kMinPartShare = 0.7, kMaxPartSigmas = 6.0, kMinPartCosine = 0.94;
// A plane is large, so its fit uses more points than others; least squares solve it in closed form,
// so it needs fewer steps.
constexpr int kFitPoints = 1000, kIterations = 2;
// Independent measurements per sample; each sample is an average over a cell.
constexpr double kEffectiveShare = 0.25;

/// A plane n·x + d = 0 in local coordinates, for samples that determine none, such as some in a
/// row.
PosedQuadric in_local(const Eigen::Vector4d& plane, const Normalisation& local) {
  const Eigen::Vector3d n = plane.head<3>();
  PosedQuadric posed;
  posed.X = pose_along(-(n.dot(local.centre) + plane[3]) / local.scale * n, n);
  posed.D(2, 3) = posed.D(3, 2) = 0.5;
  return posed;
}

/// True if most of a flat surface lies on the plane.
bool lies_on(const Surface& flat, const SurfaceSamples& samples, const PlaneRegion& plane,
             const SurfaceSamples& coarse) {
  const Eigen::Vector3d n = plane.plane.head<3>();
  if (std::abs(flat.Q.gradient(flat.local.centre).normalized().dot(n)) < kMinPartCosine)
    return false;
  const double wave = kMaxWaviness * (middle_of(coarse, plane) - flat.local.centre).norm();
  const auto on = std::count_if(flat.region.begin(), flat.region.end(), [&](int i) {
    const double d = plane.plane.dot(samples.raw[i].cast<double>().homogeneous());
    return std::abs(d) < std::max(kMaxPartSigmas * samples.sigma[i], wave);
  });
  return static_cast<double>(on) > kMinPartShare * static_cast<double>(flat.region.size());
}

}  // namespace

Surface plane_surface(const SurfaceSamples& samples, const PlaneRegion& plane) {
  const Normalisation local = normalisation_of(samples, plane.samples);
  const OrientedPointsf points = fit_points(samples, plane.samples, local, kFitPoints);
  const PosedQuadric start =
      initial_plane(PointMoments(points)).value_or(in_local(plane.plane, local));
  std::optional<FamilyFit> fit = refine(points, Family::kPlane, start, kIterations);
  if (!fit) fit = FamilyFit{Family::kPlane, start, 0.0, static_cast<int>(points.size())};
  Surface surface = surface_of(plane.samples, local, std::move(*fit), points);
  surface.effective_size = kEffectiveShare * static_cast<double>(surface.region.size());
  return surface;
}

std::vector<Surface> weighed_planes(const SurfaceSamples& samples,
                                    const std::vector<PlaneRegion>& planes,
                                    const SceneContext& context) {
  const SampleBlocks blocks(samples);
  std::vector<Surface> surfaces;
  for (const PlaneRegion& plane : planes) {
    weigh({samples, blocks, context, nullptr},
          &surfaces.emplace_back(plane_surface(samples, plane)));
  }
  return surfaces;
}

bool is_part_of(const Surface& flat, const SurfaceSamples& samples,
                const std::vector<PlaneRegion>& planes, const SurfaceSamples& coarse) {
  return std::any_of(planes.begin(), planes.end(), [&](const PlaneRegion& plane) {
    return lies_on(flat, samples, plane, coarse);
  });
}

}  // namespace quadrille
