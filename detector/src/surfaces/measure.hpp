#pragma once

#include "quadrille/detector/detection.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// Names and measures a surface: type and canonical pose by eigen-analysis of its fit, dimensions
/// with their standard deviations, the extent of its samples, and the share of it that was seen.
///
/// Standard deviations come from the covariance of the fit, s² (JᵀJ)⁻¹ scaled to the effective
/// number of measurements, through the derivative of the dimensions.
/// @param eye  the viewpoint in frame C [m]
Detection measure(const Surface& surface, const SurfaceSamples& samples,
                  const Eigen::Vector3d& eye);

}  // namespace quadrille
