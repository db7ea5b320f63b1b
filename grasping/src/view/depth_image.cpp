#include "view/depth_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

// Depths of neighbours on one surface differ by less than this share, even if it is seen at 80° in
// pixels of 1/300 of its depth.
constexpr float kMaxStep = 0.02f;
// A pixel with fewer neighbours at its depth is a stray. Along a wire that is one pixel wide there
// are two.
constexpr int kMinAlike = 2;
// A missing pixel with at least this many measured neighbours is filled. A pixel beside a straight
// edge has three as well, so objects grow by one pixel there.
constexpr int kMinMeasured = 3;

bool alike(float depth, float other) {
  return other > 0.0f && std::abs(other - depth) < kMaxStep * depth;
}

/// Returns true if enough of the eight neighbours lie on one surface with the pixel.
bool has_support(const DepthImage& image, int u, int v) {
  const float depth = image.at(u, v);
  // Quick test: usually both neighbours in the row do.
  if (alike(depth, image.at(u - 1, v)) && alike(depth, image.at(u + 1, v))) return true;
  int found = -1;  // does not count the pixel itself
  for (int y = v - 1; y <= v + 1; ++y) {
    for (int x = u - 1; x <= u + 1; ++x) found += alike(depth, image.at(x, y));
  }
  return found >= kMinAlike;
}

}  // namespace

std::vector<std::size_t> find_strays(const DepthImage& image) {
  std::vector<std::size_t> strays;
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      if (image.at(u, v) > 0.0f && !has_support(image, u, v)) strays.push_back(image.index(u, v));
    }
  }
  return strays;
}

DepthImage fill_holes(const DepthImage& raw) {
  DepthImage image = raw;
  for (int v = 1; v + 1 < image.height; ++v) {
    for (int u = 1; u + 1 < image.width; ++u) {
      if (raw.at(u, v) > 0.0f) continue;
      int known = 0;
      float min_depth = std::numeric_limits<float>::max();
      for (int y = v - 1; y <= v + 1; ++y) {
        for (int x = u - 1; x <= u + 1; ++x) {
          const float depth = raw.depth[raw.index(x, y)];
          if (depth == 0.0f) continue;
          ++known;
          min_depth = std::min(min_depth, depth);
        }
      }
      if (known >= kMinMeasured) image.depth[image.index(u, v)] = min_depth;
    }
  }
  return image;
}

}  // namespace quadrille
