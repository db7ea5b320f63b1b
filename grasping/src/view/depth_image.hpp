#pragma once

#include <cstddef>
#include <vector>

namespace quadrille {

/// Depths that the pixels of a pinhole measured, along its axis [m], row by row; 0 where missing.
struct DepthImage {
  int width = 0, height = 0;
  std::vector<float> depth;

  bool holds(int u, int v) const { return u >= 0 && v >= 0 && u < width && v < height; }
  std::size_t index(int u, int v) const { return static_cast<std::size_t>(v) * width + u; }
  /// Depth at a pixel, 0 outside the image.
  float at(int u, int v) const { return holds(u, v) ? depth[index(u, v)] : 0.0f; }
};

/// Takes out the pixels without support among their neighbours: stray and mixed ones.
/// @return their indices
std::vector<std::size_t> remove_strays(DepthImage& image);

/// Gives missing pixels with a few measured neighbours the smallest of their depths.
void fill_holes(DepthImage& image);

}  // namespace quadrille
