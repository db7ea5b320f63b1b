#pragma once

#include <span>

#include "quadrille/detector/detection.hpp"
#include "samples/sight.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// Names and measures a surface: type and canonical pose by eigen-analysis of its fit, dimensions
/// with standard deviations, the extent of its samples, and the share of it that was seen.
///
/// Standard deviations are those of uncertainty_of(). The length of a cylinder is a guess if an
/// occluder or the border of the image hides an end.
/// @param eye     the viewpoint in frame C [m]
/// @param sights  depths that the sensor saw in each view; without any, each end counts as seen
Detection measure(const Surface& surface, const SurfaceSamples& samples, const Eigen::Vector3d& eye,
                  std::span<const Sight> sights = {});

}  // namespace quadrille
