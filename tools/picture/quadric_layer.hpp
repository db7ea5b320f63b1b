#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "picture/image.hpp"
#include "picture/view.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Draws one detection over the cloud: the points on it tinted; if it is curved also the outline of
/// its surface within the extent of its inliers and lines of constant height and angle. Nothing
/// hides the lines.
/// @return the topmost pixel in the middle of the drawn surface, for a label; nullopt if none of it
///         is in view
std::optional<Eigen::Vector2i> draw_quadric(const Detection& detection, const Color& color,
                                            const std::vector<float>& depth, const View& view,
                                            Image* image);

}  // namespace quadrille
