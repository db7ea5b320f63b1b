#pragma once

#include <vector>

#include "quadrille/detector/canonical.hpp"
#include "quadrille/detector/detection.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// What the samples of a surface leave open of its quadric.
struct Uncertainty {
  /// Standard deviation of each canonical dimension [m], of angles [rad]; infinite where the
  /// samples do not show the dimension and its value is a guess.
  std::vector<double> std;
  QuadricCovariance covariance;
};

/// The covariance of a surface's fit, V (JᵀJ / N)⁻¹ with N points and the variance V of their mean
/// noise, and through the derivatives by the family's parameters that of q and of the dimensions.
///
/// V has three parts: noise of its own on each point is averaged over all points; waves of noise
/// over the blocks that they are shorter than; what is larger, a bent depth image or a flaw of the
/// body, is followed by the fit as the surface is, and hardly averaged at all.
/// @param form  of the surface's fit, in its local coordinates
Uncertainty uncertainty_of(const Surface& surface, const SurfaceSamples& samples,
                           const CanonicalForm& form);

}  // namespace quadrille
