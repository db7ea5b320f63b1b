#include "surfaces/last_fit.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "surfaces/surface_fit.hpp"

namespace quadrille {
namespace {

// Number of steps of the fit, which starts near its end.
constexpr int kIterations = 4;
// Least cosine between the normal and the line of sight: 75°, the steepest that neighbouring cells
// continue each other; see continuous_step(). Steeper cells lie at the outline, where they are
// partly filled and mixed with what lies behind.
constexpr float kMinCosine = 0.26f;

/// The samples of a surface in its local coordinates, moved by what averaging over cells took off.
OrientedPointsf points_on(const Surface& surface, const SurfaceSamples& samples,
                          const std::vector<Eigen::Matrix3f>& scatter,
                          const std::vector<Sight>& sights) {
  const int size = static_cast<int>(surface.region.size());
  OrientedPointsf points = fit_points(samples, surface.region, surface.local, size);
  const Eigen::Matrix4f Q = surface.fit.posed.matrix().cast<float>();
  std::vector<Eigen::Vector3f> eyes;
  eyes.reserve(sights.size());
  for (const Sight& sight : sights) eyes.push_back(sight.X_VC.inverse().translation());
  const float square = static_cast<float>(surface.local.scale * surface.local.scale);
  Eigen::Index kept = 0;
  for (int k = 0; k < size; ++k) {
    const int i = surface.region[k];
    const Eigen::Vector3f x = points.points.col(k);
    const Eigen::Vector3f h = (Q * x.homogeneous()).head<3>();
    const float slope = h.norm();
    const Eigen::Vector3f n = h / slope;
    const std::size_t view = samples.view_of(i);
    const bool sighted = view < sights.size() && !sights[view].w.empty();
    const Eigen::Vector3f ray = sighted ? (samples.raw[i] - eyes[view]).normalized() : n;
    const float cosine = n.dot(ray);
    if (!(std::abs(cosine) >= kMinCosine)) continue;
    // The map of a point's offset from its cell's mean to the surface, along the line of sight.
    const Eigen::Matrix3f T = Eigen::Matrix3f::Identity() - ray * n.transpose() / cosine;
    const Eigen::Matrix3f S = T * scatter[samples.source[i]] * T.transpose() / square;
    const float off = Q.topLeftCorner<3, 3>().cwiseProduct(S).sum() / (2.0f * slope);
    points.points.col(kept) = x + off * n;
    points.normals.col(kept++) = points.normals.col(k).eval();
  }
  return points.first(kept);
}

}  // namespace

Surface last_fit(Surface surface, const SurfaceSamples& samples,
                 const std::vector<Eigen::Matrix3f>& scatter, const std::vector<Sight>& sights) {
  if (is_flat(surface)) return surface;
  const OrientedPointsf points = points_on(surface, samples, scatter, sights);
  std::optional<FamilyFit> fit = refine(points, surface.fit.family, surface.fit.posed, kIterations);
  if (!fit || canonical_form(fit->posed).type != canonical_form(surface.fit.posed).type) {
    return surface;
  }
  Surface refitted = surface_of(std::move(surface.region), surface.local, std::move(*fit), points);
  refitted.evidence = surface.evidence;
  refitted.confidence = surface.confidence;
  refitted.effective_size = surface.effective_size;
  return refitted;
}

}  // namespace quadrille
