#include "view/depth_bounds.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace quadrille {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Clips a span to an image; a span that is empty or lies outside gives an empty one.
PixelSpan clipped(const PixelSpan& s, int width, int height) {
  return {std::max(s.min_u, 0), std::min(s.max_u, width - 1), std::max(s.min_v, 0),
          std::min(s.max_v, height - 1)};
}

}  // namespace

DepthBounds::DepthBounds(const DepthImage& image, const DepthImage& measured)
    : width_(image.width), height_(image.height) {
  std::vector<float> surface = measured.depth;
  std::replace(surface.begin(), surface.end(), 0.0f, kInfinity);
  levels_.push_back({image.width, image.height, image.depth, image.depth, std::move(surface)});
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    levels_.push_back(coarser(levels_.back()));
  }
}

DepthBounds::Level DepthBounds::coarser(const Level& fine) {
  Level level;
  level.width = (fine.width + 1) / 2;
  level.height = (fine.height + 1) / 2;
  const auto less = [](float a, float b) { return std::min(a, b); };
  level.min = joined(fine, fine.min, less);
  level.max = joined(fine, fine.max, [](float a, float b) { return std::max(a, b); });
  level.surface = joined(fine, fine.surface, less);
  return level;
}

/// Joins two by two values of a level into one.
template <class Better>
std::vector<float> DepthBounds::joined(const Level& fine, const std::vector<float>& values,
                                       Better&& better) {
  const int width = (fine.width + 1) / 2, height = (fine.height + 1) / 2;
  std::vector<float> coarse(static_cast<std::size_t>(width) * height);
  float* to = coarse.data();
  for (int v = 0; v < height; ++v) {
    const float* row0 = values.data() + static_cast<std::size_t>(2 * v) * fine.width;
    const float* row1 = 2 * v + 1 < fine.height ? row0 + fine.width : row0;
    for (int u = 0; u < fine.width / 2; ++u) {
      *to++ = better(better(row0[2 * u], row0[2 * u + 1]), better(row1[2 * u], row1[2 * u + 1]));
    }
    // The last column of an odd number has no neighbour.
    if (fine.width % 2 == 1) *to++ = better(row0[fine.width - 1], row1[fine.width - 1]);
  }
  return coarse;
}

/// Returns the level at which a span within the image is at most two pixels wide and high.
int DepthBounds::level_of(const PixelSpan& s) const {
  const auto steps = static_cast<unsigned>(std::max(s.max_u - s.min_u, s.max_v - s.min_v));
  return std::min(steps < 2 ? 0 : static_cast<int>(std::bit_width(steps - 1)),
                  static_cast<int>(levels_.size()) - 1);
}

DepthRange DepthBounds::range(const PixelSpan& span) const {
  const PixelSpan s = clipped(span, width_, height_);
  if (s.min_u > s.max_u || s.min_v > s.max_v) return {0.0, 0.0};
  const bool cut =
      span.min_u < 0 || span.min_v < 0 || span.max_u >= width_ || span.max_v >= height_;
  const int k = level_of(s);
  const Level& level = levels_[k];
  const std::array<std::size_t, 4> at = level.corners(s, k);
  // Unlike vectors, these do not check each access.
  const float *min = level.min.data(), *max = level.max.data();
  const float least = std::min(std::min(min[at[0]], min[at[1]]), std::min(min[at[2]], min[at[3]]));
  const float most = std::max(std::max(max[at[0]], max[at[1]]), std::max(max[at[2]], max[at[3]]));
  return {cut ? 0.0 : least, most};
}

double DepthBounds::nearest_surface(const PixelSpan& span) const {
  const PixelSpan s = clipped(span, width_, height_);
  if (s.min_u > s.max_u || s.min_v > s.max_v) return kInfinity;
  const int k = level_of(s);
  const Level& level = levels_[k];
  const std::array<std::size_t, 4> at = level.corners(s, k);
  const float* surface = level.surface.data();
  return std::min(std::min(surface[at[0]], surface[at[1]]),
                  std::min(surface[at[2]], surface[at[3]]));
}

}  // namespace quadrille
