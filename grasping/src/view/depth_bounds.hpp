#pragma once

#include <cstdint>
#include <vector>

#include "view/depth_image.hpp"

namespace quadrille {

/// Bounds of what the pixels of a region measured [m]; min is 0 where a pixel is missing.
struct DepthRange {
  double min = 0.0, max = 0.0;
};

/// Pixels from (min_u, min_v) up to and with (max_u, max_v); none if a maximum is the smaller.
struct PixelSpan {
  int min_u, max_u, min_v, max_v;
};

/// Bounds of the depth over any rectangle of pixels, from a few looks at a pyramid of images: each
/// level holds the bounds over two by two pixels of the one before. They may be those of a
/// rectangle up to four times as large.
class DepthBounds {
 public:
  DepthBounds() = default;
  /// @param filled  per pixel, whether its depth was not measured
  DepthBounds(const DepthImage& image, const std::vector<std::uint8_t>& filled);

  /// Over the pixels of a span; those outside the image are missing.
  DepthRange range(const PixelSpan& span) const;
  /// Smallest depth that a pixel of the span measured, infinite if none did.
  double nearest_surface(const PixelSpan& span) const;

 private:
  struct Level {
    int width = 0, height = 0;
    std::vector<float> min, max;
    /// Smallest depth that was measured, infinite if none was.
    std::vector<float> surface;
  };
  static Level coarser(const Level& fine);
  int level_of(const PixelSpan& span) const;

  int width_ = 0, height_ = 0;
  std::vector<Level> levels_;
};

}  // namespace quadrille
