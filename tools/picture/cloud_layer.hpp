#pragma once

#include "picture/image.hpp"
#include "picture/view.hpp"

namespace quadrille {

/// Draws the points of a cloud in their own colours if they have any, otherwise in grey, shaded by
/// their smoothed normals and darker with distance.
void draw_cloud(const CloudImage& cloud, const View& view, Image* image);

}  // namespace quadrille
