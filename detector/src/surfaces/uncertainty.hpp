#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/quadric.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// The uncertainty that the samples of a surface leave about its quadric.
struct Uncertainty {
  /// Standard deviation of each canonical dimension [m], of angles [rad]; infinite if the samples
  /// do not show the dimension and its value is a guess.
  std::vector<double> std;
  QuadricCovariance covariance;
};

/// Computes the covariance of a surface's fit, V (JᵀJ / N)⁻¹, where N is the number of points and V
/// the variance of their mean noise, and from it, through the derivatives by the family's
/// parameters, that of q and of the dimensions.
///
/// V has several parts. Noise is averaged over the samples, over fewer where neighbours share it;
/// see effective_share(). What the residuals exceed the measured noise by is not averaged at all:
/// waves longer than the patches in which noise is measured, a bent depth image or a flaw of the
/// body are followed by the fit like the surface itself. Nor is what the points of a lid's outline
/// may be off together.
/// @param form  canonical form of the surface's fit, in its local coordinates
Uncertainty uncertainty_of(const Surface& surface, const SurfaceSamples& samples,
                           const CanonicalForm& form);

}  // namespace quadrille
