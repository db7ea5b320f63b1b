#include "surfaces/last_fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "surfaces/surface_fit.hpp"

namespace quadrille {
namespace {

// Number of steps of the fit, which starts near its end.
constexpr int kIterations = 4;
// Least cosine between the normal and the line of sight: 75°, the steepest that neighbouring cells
// continue each other; see continuous_step().
constexpr float kMinCosine = 0.26f;

/// The map of a point's offset from its cell's mean to the surface with normal n, along the line of
/// sight.
Eigen::Matrix3f onto_surface(const Eigen::Vector3f& n, const Eigen::Vector3f& ray) {
  const Eigen::Matrix3f across = Eigen::Matrix3f::Identity() - ray * ray.transpose();
  const float cosine = n.dot(ray);
  const float bounded = std::copysign(std::max(std::abs(cosine), kMinCosine), cosine);
  return across - ray * (n - cosine * ray).transpose() / bounded;
}

/// The samples of a surface in its local coordinates, moved by what averaging over cells took off.
OrientedPointsf points_on(const Surface& surface, const SurfaceSamples& samples,
                          const std::vector<Eigen::Matrix3f>& scatter, const Sight& sight) {
  const int size = static_cast<int>(surface.region.size());
  OrientedPointsf points = fit_points(samples, surface.region, surface.local, size);
  const Eigen::Matrix4f Q = surface.fit.posed.matrix().cast<float>();
  const Eigen::Vector3f eye = sight.X_VC.inverse().translation();
  const float square = static_cast<float>(surface.local.scale * surface.local.scale);
  for (int k = 0; k < size; ++k) {
    const int i = surface.region[k];
    const Eigen::Vector3f h = (Q * points.points.col(k).homogeneous()).head<3>();
    const float slope = h.norm();
    if (!(slope > 0.0f)) continue;
    const Eigen::Vector3f n = h / slope;
    const Eigen::Matrix3f T =
        onto_surface(n, sight.w.empty() ? n : (samples.raw[i] - eye).normalized());
    const Eigen::Matrix3f S = T * scatter[samples.source[i]] * T.transpose() / square;
    points.points.col(k) += Q.topLeftCorner<3, 3>().cwiseProduct(S).sum() / (2.0f * slope) * n;
  }
  return points;
}

}  // namespace

Surface last_fit(Surface surface, const SurfaceSamples& samples,
                 const std::vector<Eigen::Matrix3f>& scatter, const Sight& sight) {
  if (is_flat(surface)) return surface;
  const OrientedPointsf points = points_on(surface, samples, scatter, sight);
  std::optional<FamilyFit> fit = refine(points, surface.fit.family, surface.fit.posed, kIterations);
  if (!fit || canonical_form(fit->posed).type != canonical_form(surface.fit.posed).type) {
    return surface;
  }
  Surface refitted = surface_of(std::move(surface.region), surface.local, std::move(*fit));
  refitted.evidence = surface.evidence;
  refitted.confidence = surface.confidence;
  refitted.effective_size = surface.effective_size;
  return refitted;
}

}  // namespace quadrille
