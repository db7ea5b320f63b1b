#pragma once

#include <cstddef>
#include <vector>

namespace quadrille {

/// Depths along the optical axis that the pixels of a pinhole camera measured [m], row by row; 0 if
/// missing.
struct DepthImage {
  int width = 0, height = 0;
  std::vector<float> depth;

  bool holds(int u, int v) const { return u >= 0 && v >= 0 && u < width && v < height; }
  std::size_t index(int u, int v) const { return static_cast<std::size_t>(v) * width + u; }
  /// Depth at a pixel, 0 outside the image.
  float at(int u, int v) const { return holds(u, v) ? depth[index(u, v)] : 0.0f; }
};

/// Returns the indices of the pixels without support among their neighbours: stray and mixed
/// pixels.
std::vector<std::size_t> find_strays(const DepthImage& image);

/// Returns the image with missing pixels that have a few measured neighbours filled with the
/// smallest of their depths.
DepthImage fill_holes(const DepthImage& image);

}  // namespace quadrille
