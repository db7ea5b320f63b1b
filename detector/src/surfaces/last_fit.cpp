#include "surfaces/last_fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "surfaces/closed_fit.hpp"
#include "surfaces/surface_fit.hpp"
#include "surfaces/uncertainty.hpp"

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
    // Only some points are looked at. A cell without any of them has no scatter, so its mean stays.
    if (scatter[i].trace() == 0.0f) {
      points.points.col(kept) = x;
      points.normals.col(kept++) = points.normals.col(k).eval();
      continue;
    }
    // The map of a point's offset from its cell's mean to the surface, along the line of sight.
    const Eigen::Matrix3f T = Eigen::Matrix3f::Identity() - ray * n.transpose() / cosine;
    const Eigen::Matrix3f S = T * scatter[i] * T.transpose() / square;
    const float off = Q.topLeftCorner<3, 3>().cwiseProduct(S).sum() / (2.0f * slope);
    points.points.col(kept) = x + off * n;
    points.normals.col(kept++) = points.normals.col(k).eval();
  }
  return points.first(kept);
}

/// The surface with another fit.
Surface refitted(const Surface& surface, FamilyFit fit, const OrientedPointsf& points) {
  Surface result = surface_of(surface.region, surface.local, std::move(fit), points);
  result.evidence = surface.evidence;
  result.confidence = surface.confidence;
  result.effective_size = surface.effective_size;
  return result;
}

/// True if two surfaces are of the same type and the first has the smaller deviations.
bool is_surer(const Surface& a, const Surface& b, const SurfaceSamples& samples) {
  const CanonicalForm form_a = canonical_form(a.fit.posed), form_b = canonical_form(b.fit.posed);
  if (form_a.type != form_b.type) return false;
  const std::vector<double> std_a = uncertainty_of(a, samples, form_a).std;
  const std::vector<double> std_b = uncertainty_of(b, samples, form_b).std;
  return *std::max_element(std_a.begin(), std_a.end()) <
         *std::max_element(std_b.begin(), std_b.end());
}

}  // namespace

LastFit last_fit(Surface surface, const SurfaceSamples& samples,
                 const std::vector<Eigen::Matrix3f>& scatter, const std::vector<Sight>& sights,
                 std::span<const OutlinePoint> outline) {
  if (is_flat(surface)) return {std::move(surface), OrientedPointsf(), 0};
  OrientedPointsf points = points_on(surface, samples, scatter, sights);
  std::optional<FamilyFit> fit = refine(points, surface.fit.family, surface.fit.posed, kIterations);
  if (!fit || canonical_form(fit->posed).type != canonical_form(surface.fit.posed).type) {
    return {std::move(surface), OrientedPointsf(), 0};
  }
  Surface alone = refitted(surface, *fit, points);
  const Eigen::Index size = points.size();
  if (outline.empty()) return {std::move(alone), std::move(points), size};
  const double noise = samples.common_noise * mean_sigma(samples, surface.region);
  const double common_noise = std::hypot(noise / surface.local.scale, kFlawShare);
  auto closed = fit_closed({std::move(*fit), points, surface.effective_size, common_noise},
                           local_outline(outline, surface.local));
  if (!closed) return {std::move(alone), std::move(points), size};
  Surface with_lid = refitted(surface, closed->fit, closed->points);
  with_lid.common_error = closed->common_error;
  LastFit result{std::move(with_lid), std::move(closed->points), size};
  result.surface.information.Jt1 = information(result.wall(), result.surface.fit).Jt1;
  if (is_surer(alone, result.surface, samples)) return {std::move(alone), std::move(points), size};
  return result;
}

}  // namespace quadrille
