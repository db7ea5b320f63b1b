#pragma once

#include <Eigen/Core>
#include <optional>

#include "picture/image.hpp"
#include "picture/view.hpp"
#include "quadrille/detector/box.hpp"

namespace quadrille {

/// Draws the edges of a box over the cloud; those that end at its hidden corner are faint.
/// @return the topmost corner, for a label; nullopt if a corner lies behind the eye or none of them
///         is in view
std::optional<Eigen::Vector2i> draw_box(const Box& box, const Color& color, const View& view,
                                        Image* image);

}  // namespace quadrille
