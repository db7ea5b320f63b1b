#include "view/depth_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "quadrille/detector/vector_clones.hpp"

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
  return (other > 0.0f) & (std::abs(other - depth) < kMaxStep * depth);
}

/// Returns true if enough of the eight neighbours lie on one surface with the pixel.
bool has_support(const DepthImage& image, int u, int v) {
  const float depth = image.at(u, v);
  int found = -1;  // does not count the pixel itself
  for (int y = v - 1; y <= v + 1; ++y) {
    for (int x = u - 1; x <= u + 1; ++x) found += alike(depth, image.at(x, y));
  }
  return found >= kMinAlike;
}

/// Marks the measured pixels of a row that do not lie on one surface with both neighbours in it.
QUADRILLE_VECTOR_CLONES
void mark_doubtful(const float* __restrict depth, int width, char* __restrict doubtful) {
  for (int u = 1; u + 1 < width; ++u) {
    doubtful[u] =
        (depth[u] > 0.0f) & !(alike(depth[u], depth[u - 1]) & alike(depth[u], depth[u + 1]));
  }
  doubtful[0] = depth[0] > 0.0f;
  doubtful[width - 1] = depth[width - 1] > 0.0f;
}

/// Fills the holes of a row between two others.
/// @param row  the first pixel of the row; the other rows lie before and after it
QUADRILLE_VECTOR_CLONES
void fill_holes_of_row(const float* __restrict row, int width, float* __restrict filled) {
  constexpr float kNone = std::numeric_limits<float>::max();
  for (int u = 1; u + 1 < width; ++u) {
    const float *here = row + u, *above = here - width, *below = here + width;
    int known = 0;
    float least = kNone;
    const auto look = [&](float depth) {
      known += static_cast<int>(depth > 0.0f);
      const float measured = depth > 0.0f ? depth : kNone;
      least = measured < least ? measured : least;
    };
    look(above[-1]), look(above[0]), look(above[1]);
    look(here[-1]), look(here[1]);
    look(below[-1]), look(below[0]), look(below[1]);
    const float fill = known >= kMinMeasured ? least : here[0];
    filled[u] = here[0] > 0.0f ? here[0] : fill;
  }
}

}  // namespace

std::vector<std::size_t> find_strays(const DepthImage& image) {
  std::vector<std::size_t> strays;
  std::vector<char> doubtful(static_cast<std::size_t>(image.width));
  for (int v = 0; v < image.height; ++v) {
    mark_doubtful(&image.depth[image.index(0, v)], image.width, doubtful.data());
    const char *begin = doubtful.data(), *end = begin + doubtful.size();
    // Unlike std::find(), this looks at many bytes at once.
    const auto next = [&](const char* from) {
      return static_cast<const char*>(std::memchr(from, 1, static_cast<std::size_t>(end - from)));
    };
    for (const char* at = next(begin); at != nullptr; at = next(at + 1)) {
      const int u = static_cast<int>(at - begin);
      if (!has_support(image, u, v)) strays.push_back(image.index(u, v));
    }
  }
  return strays;
}

DepthImage fill_holes(const DepthImage& raw) {
  DepthImage image = raw;
  for (int v = 1; v + 1 < image.height; ++v) {
    fill_holes_of_row(&raw.depth[raw.index(0, v)], image.width, &image.depth[image.index(0, v)]);
  }
  return image;
}

}  // namespace quadrille
