#pragma once

#include <Eigen/Core>

#include "view/depth_image.hpp"

namespace quadrille {

/// The assumptions by which gaps in a depth image are filled.
struct GapRules {
  /// Largest distance between the sensor's two eyes, along the rows [m]; 0 if they do not lie along
  /// the rows.
  double baseline = 0.0;
  /// Objects thinner than this do not matter [m].
  double thin = 0.0;
};

/// Returns the image with missing pixels filled with the depth up to which nothing can stand there;
/// others stay missing.
///
/// Blind bands: beside the edge of a near object, a sensor with two eyes (or an eye and a
/// projector) is blind where the object stands between the farther surface and its second eye. The
/// second eye's line of sight over the edge has an inverse depth that changes linearly along the
/// row, from that of the near edge to that of the first surface beyond; both eyes would have seen
/// anything in front of this line. A gap wider than the baseline explains, b(1/z₀ − 1/z₁) in
/// tangents of the ray, has another cause (a dark or shiny object, no surface in range).
///
/// Narrow gaps: an object in a gap of tangent w at depth z is thinner than w·z, so no object of
/// relevant size stands nearer than thin/w. In both cases the filled depth is at most that of the
/// nearer end of the gap.
/// @param image  depths; a missing pixel is 0
/// @param pitch  tangent of the angle between neighbouring pixels along and across the rows
DepthImage fill_gaps(const DepthImage& image, const Eigen::Vector2d& pitch, const GapRules& rules);

}  // namespace quadrille
