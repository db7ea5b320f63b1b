#include "boxes/flat_patches.hpp"

#include "planes/planes.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {
namespace {

// Least number of samples of a patch, which are enough for a plane and its noise.
constexpr int kMinSamples = 12;
// Least radius to which a patch may bend [m]. It is small, since its samples average over rounded
// edges. Whether it is flat is judged later by its points.
constexpr double kMinRadius = 0.05;
// At most so many patches are looked at, the largest, so that clutter takes no more time than
// boxes.
constexpr std::size_t kMaxPatches = 16;

}  // namespace

std::vector<FlatPatch> find_flat_patches(const SurfaceSamples& samples, const PlaneOptions& options,
                                         const Mask& free) {
  PlaneOptions lax = options;
  lax.min_samples = kMinSamples;
  lax.min_radius = kMinRadius;
  lax.min_proven_radius = 0.0;
  std::vector<FlatPatch> patches;
  std::vector<PlaneRegion> planes = find_planes(samples, lax, free);
  if (planes.size() > kMaxPatches) planes.resize(kMaxPatches);
  for (const PlaneRegion& plane : planes) {
    std::vector<Eigen::Vector3d> points_C;
    for (const int i : plane.samples) points_C.push_back(samples.raw[i].cast<double>());
    const Eigen::Vector3d n = plane.plane.head<3>(), x = n.unitOrthogonal();
    Eigen::Matrix3d R_CL;
    R_CL << x, n.cross(x), n;
    patches.push_back({patch_around(points_C, R_CL), mean_sigma(samples, plane.samples)});
  }
  return patches;
}

}  // namespace quadrille
