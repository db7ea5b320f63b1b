#pragma once

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
  /// Quadric in frame C with |q| = 1.
  Quadric Q;
  /// Fit in local coordinates, and the map to them.
  FamilyFit fit;
  Normalisation local;
  /// How well the points determine the fit; see information().
  FitInformation information;
  std::vector<int> region;
  /// Root mean square distance of the region's samples [m].
  double rms = 0.0;
  Evidence evidence;
  double confidence = 0.0;
  /// Number of independent measurements on which the fit rests.
  double effective_size = 1.0;
  /// Standard deviation of what points of the fit that are no samples may be off together, in local
  /// coordinates; see fit_closed().
  double common_error = 0.0;
};

/// True if the surface is a plane.
inline bool is_flat(const Surface& surface) { return surface.fit.family == Family::kPlane; }

/// Canonical form of a surface's quadric, with its pose in frame C. Its dimensions are in the unit
/// of the local coordinates.
CanonicalForm form_of(const Surface& surface);

/// Mean standard deviation along the normals of the samples of a region, which must not be empty
/// [m].
double mean_sigma(const SurfaceSamples& samples, std::span<const int> region);

/// The terms of a surface's confidence; see confidence_terms(). The surface's evidence must be set.
ConfidenceTerms terms_of(const Surface& surface);

/// True if a surface is so thin that its two sides coincide within the noise. Near a doubled plane
/// the first-order distance is half the true one, so such fits look too good. A hyperbolic cylinder
/// that turns within one cell is the edge between two planes.
bool is_thin(const Surface& surface, const SurfaceSamples& samples);

/// Root mean square first-order distance of the samples of a region, which must not be empty, from
/// a quadric [m].
double rms_distance(const Quadric& quadric, const SurfaceSamples& samples,
                    std::span<const int> region);

}  // namespace quadrille
