#pragma once

#include <optional>
#include <span>
#include <vector>

#include "quadrille/detector/family.hpp"
#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/region.hpp"
#include "quadrille/detector/surface_samples.hpp"

namespace quadrille {

/// A quadric with the samples that support it.
struct Candidate {
  Quadric Q;
  Family family = Family::kGeneral;
  /// Indices into the samples that it was found on.
  std::vector<int> region;
  /// Root mean square distance of the region [m].
  double rms = 0.0;
};

/// How far and how often a hypothesis is grown.
struct GrowOptions {
  /// Families that a refit chooses from; a single one is fitted without a choice.
  std::vector<Family> families = {Family::kPlane, Family::kSphere, Family::kCylinder, Family::kCone,
                                  Family::kRevolution};
  /// Samples that a candidate has at least.
  int least_samples = 25;
  /// Rounds of growing and refitting.
  int rounds = 5;
  /// Points that a fit uses at most.
  int fit_points = 128;
};

/// Grows a hypothesis over connected inliers and refits it, in turn, until it settles. A
/// refit selects the simplest family that explains the region, as ten free coefficients from a
/// small patch would lead the growth astray, and keeps it until the region has outgrown the choice.
/// @param start  samples to begin with
/// @param free   per sample, zero to stay out of it
/// @return nullopt if the region gets too small or has no fit
std::optional<Candidate> grow(const SurfaceSamples& samples, const Quadric& hypothesis,
                              std::span<const int> start, const std::vector<char>& free,
                              const InlierTest& inlier, const GrowOptions& options);

}  // namespace quadrille
