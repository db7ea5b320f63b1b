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
/// Noise that each sample has of its own is averaged over all samples. Noise that neighbours share
/// is not averaged at all: the waves of depth sensors are as long as the bodies that they show, and
/// so are other errors, such as a bent depth image or a flaw of the body. Hence V is the variance
/// of the residuals times 1 / N + c, where c is the correlation of neighbours beyond chance.
/// @param form  canonical form of the surface's fit, in its local coordinates
Uncertainty uncertainty_of(const Surface& surface, const SurfaceSamples& samples,
                           const CanonicalForm& form);

}  // namespace quadrille
