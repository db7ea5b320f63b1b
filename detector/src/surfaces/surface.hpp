#pragma once

#include <array>
#include <span>
#include <vector>

#include "fit/geometric_fit.hpp"
#include "quadrille/detector/quadric.hpp"
#include "samples/region.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/evidence/confidence.hpp"
#include "surfaces/evidence/evidence.hpp"

namespace quadrille {

/// A surface of the scene: one fitted quadric and the samples on it.
struct Surface {
  /// In frame C, |q| = 1.
  Quadric Q;
  /// The fit in local coordinates.
  FamilyFit fit;
  Normalisation local;
  std::vector<int> region;
  /// Root mean square distance of the region [m].
  double rms = 0.0;
  Evidence evidence;
  double confidence = 0.0;
  /// Independent measurements that the fit rests on.
  double effective_size = 1.0;
};

/// True for planes.
inline bool is_flat(const Surface& surface) { return surface.fit.family == Family::kPlane; }

/// Mean standard deviation of the samples of a region that is not empty, along their normals [m].
double mean_sigma(const SurfaceSamples& samples, std::span<const int> region);

/// The terms of a surface's confidence; see confidence_terms(). Its evidence must be known.
std::array<double, kConfidenceTerms.size()> terms_of(const Surface& surface);

/// Confidence in a surface whose evidence is known, by the model of curved or of flat ones.
double confidence_of(const Surface& surface);

/// True if the surface is so thin that its two sides lie within the noise of each other: next to a
/// doubled plane the first-order distance is half the true one, and such fits look too good.
/// A hyperbolic cylinder that turns within one cell is the edge between two planes.
bool is_thin(const Surface& surface, const SurfaceSamples& samples);

/// Root mean square first-order distance of the samples of a region that is not empty from the
/// surface's quadric [m].
double rms_distance(const Surface& surface, const SurfaceSamples& samples,
                    std::span<const int> region);

}  // namespace quadrille
