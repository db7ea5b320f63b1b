#pragma once

#include <vector>

#include "picture/image.hpp"
#include "picture/view.hpp"

namespace quadrille {

/// Paints a depth image in grey, shaded by its smoothed normals and darker with distance.
void draw_cloud(const std::vector<float>& depth, const View& view, Image* image);

}  // namespace quadrille
