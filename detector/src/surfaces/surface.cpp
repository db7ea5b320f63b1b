#include "surfaces/surface.hpp"

#include <algorithm>
#include <cmath>

#include "fit/family_spec.hpp"
#include "quadrille/detector/quadric.hpp"
#include "samples/inliers.hpp"

namespace quadrille {
namespace {

// A length below this many sigma is noise, and so is an angle [rad] that opens by less over the
// size of the region.
constexpr double kMinLengthSigmas = 3.0, kMinAngle = 0.02;

}  // namespace

CanonicalForm form_of(const Surface& surface) {
  CanonicalForm form = canonical_form(surface.fit.posed);
  form.X.translation() = surface.local.centre + surface.local.scale * form.X.translation();
  return form;
}

double mean_sigma(const SurfaceSamples& samples, std::span<const int> region) {
  double sum = 0;
  for (const int i : region) sum += samples.sigma[i];
  return sum / static_cast<double>(region.size());
}

ConfidenceTerms terms_of(const Surface& surface) {
  const QuadricType type = canonical_form(surface.fit.posed).type;
  return confidence_terms(surface.evidence, family_spec(surface.fit.family).dof, log_prior(type));
}

bool is_thin(const Surface& surface, const SurfaceSamples& samples) {
  const CanonicalForm form = canonical_form(surface.fit.posed);
  if (is_imaginary(form.type)) return true;
  double min_length = kMinLengthSigmas * mean_sigma(samples, surface.region) / surface.local.scale;
  if (form.type == QuadricType::kHyperbolicCylinder) {
    min_length = std::max(min_length, samples.cell[surface.region.front()] / surface.local.scale);
  }
  const bool paraboloid = form.type == QuadricType::kEllipticParaboloid ||
                          form.type == QuadricType::kHyperbolicParaboloid;
  return std::any_of(form.dimensions.begin(), form.dimensions.end(), [&](const auto& dimension) {
    const auto& [name, value] = dimension;
    // A paraboloid x² = 4 f z is about 2 √f wide at unit distance, the size of the region.
    if (paraboloid) return 2.0 * std::sqrt(value) < min_length;
    return value < (is_angle(name) ? kMinAngle : min_length);
  });
}

double rms_distance(const Quadric& quadric, const SurfaceSamples& samples,
                    std::span<const int> region) {
  const Eigen::Matrix4f Q = quadric.matrix().cast<float>();
  double sum = 0;
  for (const int i : region) {
    const double d = distance_to(Q, samples.raw[i]);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(region.size()));
}

}  // namespace quadrille
