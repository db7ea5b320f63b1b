#pragma once

#include <Eigen/Core>
#include <vector>

#include "picture/sketch.hpp"
#include "picture/view.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// What is drawn of a curved detection.
struct QuadricSketch {
  Sketch sketch;
  /// Points of the picture that its surface covers, some pixels apart.
  std::vector<Eigen::Vector2d> covered;
  /// The distance between them [pixels].
  double step = 0.0;
};

/// The outline of a curved surface within the extent of its inliers, and lines of constant height
/// and angle. Nothing hides the lines; of a flat one nothing is drawn.
QuadricSketch sketch_quadric(const Detection& detection, const Color& color, const View& view);

/// Tints the points of the cloud that lie on a detection.
/// @param depth, view, image  of one size
void tint_quadric(const Detection& detection, const Color& color, const std::vector<float>& depth,
                  const View& view, Image* image);

}  // namespace quadrille
