#pragma once

#include <Eigen/Core>
#include <vector>

#include "picture/sketch.hpp"
#include "picture/view.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// The drawing of a curved detection.
struct QuadricSketch {
  Sketch sketch;
  /// Points of the picture that the surface covers, some pixels apart.
  std::vector<Eigen::Vector2d> covered;
  /// Distance between these points [pixels].
  double step = 0.0;
};

/// Draws the outline of a curved surface within the extent of its inliers, and lines of constant
/// height and angle. Lines are drawn even where something hides them. Nothing is drawn for a flat
/// surface.
QuadricSketch sketch_quadric(const Detection& detection, const Color& color, const View& view);

/// Tints the points of the cloud that lie on a detection.
/// @param depth,  view, image  all of the same size
void tint_quadric(const Detection& detection, const Color& color, const std::vector<float>& depth,
                  const View& view, Image* image);

}  // namespace quadrille
