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
/// V has three parts. Independent noise is averaged over all points. Noise waves are averaged over
/// blocks longer than they are. Larger deviations, such as a bent depth image or a flaw of the
/// body, are followed by the fit like the surface itself and hardly averaged at all.
/// @param form  canonical form of the surface's fit, in its local coordinates
Uncertainty uncertainty_of(const Surface& surface, const SurfaceSamples& samples,
                           const CanonicalForm& form);

}  // namespace quadrille
