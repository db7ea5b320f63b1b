#pragma once

#include "picture/sketch.hpp"
#include "picture/view.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Draws the edges of a box; those that end at its hidden corner are faint. Draws nothing if a
/// corner lies behind the eye or none of them is in view.
Sketch sketch_box(const Box& box, const Color& color, const View& view);

}  // namespace quadrille
