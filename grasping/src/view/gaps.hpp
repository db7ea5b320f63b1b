#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace quadrille {

/// What is known of the gaps in a depth image.
struct GapRules {
  /// Largest distance between the sensor's two eyes, along the rows [m]; 0 if they do not lie so.
  double baseline = 0.0;
  /// Things thinner than this are not looked for [m].
  double thin = 0.0;
};

/// Fills missing pixels with the depth up to which nothing can stand there; others stay missing.
///
/// Blind bands: beside the edge of a near thing a sensor with two eyes (or an eye and a projector)
/// is blind where the thing stands between the farther surface and its second eye. That eye's line
/// of sight over the edge has an inverse depth that changes linearly along the row, from that of
/// the near edge to that of the first surface beyond; all before that line both eyes would have
/// seen. A gap wider than the baseline explains, b(1/z₀ − 1/z₁) in tangents of the ray, has another
/// cause (a dark or shiny thing, no surface in range).
///
/// Narrow gaps: what stands in a gap of tangent w at depth z is thinner than w·z, so that nothing
/// of the size that counts stands before thin/w. Not beyond the nearer end of the gap either way.
/// @param depth  row by row [m], 0 where missing; filled
/// @param pitch  tangent between neighbouring pixels along and across the rows
/// @return for each pixel, whether it was filled
std::vector<std::uint8_t> fill_gaps(std::vector<float>& depth, int width,
                                    const Eigen::Vector2d& pitch, const GapRules& rules);

}  // namespace quadrille
