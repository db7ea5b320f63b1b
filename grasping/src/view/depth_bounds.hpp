#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "view/depth_image.hpp"

namespace quadrille {

/// Bounds of the depths that the pixels of a region measured [m]; min is 0 if a pixel is missing.
struct DepthRange {
  double min = 0.0, max = 0.0;
};

/// The pixels from (min_u, min_v) to (max_u, max_v), inclusive; empty if a maximum is below its
/// minimum.
struct PixelSpan {
  int min_u, max_u, min_v, max_v;
};

/// Bounds the depth over any rectangle of pixels with a few look-ups in a pyramid of images, in
/// which each level holds the bounds over two by two pixels of the previous one. The bounds may be
/// those of a rectangle up to four times as large.
class DepthBounds {
 public:
  DepthBounds() = default;
  /// @param image  the measured depths, and those of gaps that were filled
  DepthBounds(const DepthImage& image, const DepthImage& measured);

  /// Returns the bounds over the pixels of a span; pixels outside the image count as missing.
  DepthRange range(const PixelSpan& span) const;
  /// Returns the smallest depth that a pixel of the span measured; infinite if none did.
  double nearest_surface(const PixelSpan& span) const;

 private:
  struct Level {
    int width = 0, height = 0;
    std::vector<float> min, max;
    /// Smallest measured depth; infinite if nothing was measured.
    std::vector<float> surface;

    /// The indices of the corners of a span at this level, the k-th, where it is at most two pixels
    /// wide and high. Corners may coincide.
    std::array<std::size_t, 4> corners(const PixelSpan& span, int k) const {
      const std::size_t row0 = static_cast<std::size_t>(span.min_v >> k) * width;
      const std::size_t row1 = static_cast<std::size_t>(span.max_v >> k) * width;
      const int u0 = span.min_u >> k, u1 = span.max_u >> k;
      return {row0 + u0, row0 + u1, row1 + u0, row1 + u1};
    }
  };
  static Level coarser(const Level& fine);
  template <class Better>
  static std::vector<float> joined(const Level& fine, const std::vector<float>& values,
                                   Better&& better);
  int level_of(const PixelSpan& span) const;

  int width_ = 0, height_ = 0;
  std::vector<Level> levels_;
};

}  // namespace quadrille
