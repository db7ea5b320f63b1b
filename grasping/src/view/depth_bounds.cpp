#include "view/depth_bounds.hpp"

#include <algorithm>
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
  const std::size_t size = static_cast<std::size_t>(level.width) * level.height;
  level.min.resize(size), level.max.resize(size), level.surface.resize(size);
  for (int v = 0; v < level.height; ++v) {
    const std::size_t row0 = static_cast<std::size_t>(2 * v) * fine.width;
    const std::size_t row1 =
        static_cast<std::size_t>(std::min(2 * v + 1, fine.height - 1)) * fine.width;
    for (int u = 0; u < level.width; ++u) {
      const int u0 = 2 * u, u1 = std::min(2 * u + 1, fine.width - 1);
      const auto join = [&](const std::vector<float>& of, auto&& better) {
        return better(better(of[row0 + u0], of[row0 + u1]), better(of[row1 + u0], of[row1 + u1]));
      };
      const auto min = [](float a, float b) { return std::min(a, b); };
      const auto max = [](float a, float b) { return std::max(a, b); };
      const std::size_t at = static_cast<std::size_t>(v) * level.width + u;
      level.min[at] = join(fine.min, min);
      level.max[at] = join(fine.max, max);
      level.surface[at] = join(fine.surface, min);
    }
  }
  return level;
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
  float min = std::numeric_limits<float>::max(), max = 0.0f;
  for (int v = s.min_v >> k; v <= s.max_v >> k; ++v) {
    for (int u = s.min_u >> k; u <= s.max_u >> k; ++u) {
      const std::size_t at = static_cast<std::size_t>(v) * level.width + u;
      min = std::min(min, level.min[at]);
      max = std::max(max, level.max[at]);
    }
  }
  return {cut ? 0.0 : min, max};
}

double DepthBounds::nearest_surface(const PixelSpan& span) const {
  const PixelSpan s = clipped(span, width_, height_);
  float nearest = kInfinity;
  if (s.min_u > s.max_u || s.min_v > s.max_v) return nearest;
  const int k = level_of(s);
  const Level& level = levels_[k];
  for (int v = s.min_v >> k; v <= s.max_v >> k; ++v) {
    for (int u = s.min_u >> k; u <= s.max_u >> k; ++u) {
      nearest = std::min(nearest, level.surface[static_cast<std::size_t>(v) * level.width + u]);
    }
  }
  return nearest;
}

}  // namespace quadrille
