#pragma once

#include <array>
#include <bit>
#include <cstddef>

#include "quadrille/detector/ingest.hpp"

namespace quadrille::io {

/// A point in memory, out of files whose points cannot be read where they stand.
struct PackedPoint {
  std::array<float, 3> position{};
  Rgb rgb{};
};

/// How an array of them lies in memory; its size is left to the caller.
inline PointLayout packed_points_layout(bool coloured) {
  PointLayout layout;
  layout.big_endian = std::endian::native == std::endian::big;
  layout.point_step = sizeof(PackedPoint);
  constexpr std::size_t kRgb = offsetof(PackedPoint, rgb);
  if (coloured) layout.rgb = {kRgb, kRgb + 1, kRgb + 2};
  return layout;
}

}  // namespace quadrille::io
