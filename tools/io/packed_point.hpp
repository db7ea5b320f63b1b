#pragma once

#include <array>
#include <bit>
#include <cstddef>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::io {

/// A point in memory, from files whose points cannot be read in place.
struct PackedPoint {
  std::array<float, 3> position{};
  Rgb rgb{};
};

/// Returns the layout of an array of packed points; the caller sets its size.
inline PointLayout packed_points_layout(bool coloured) {
  PointLayout layout;
  layout.big_endian = std::endian::native == std::endian::big;
  layout.point_step = sizeof(PackedPoint);
  constexpr std::size_t kRgb = offsetof(PackedPoint, rgb);
  if (coloured) layout.rgb = {kRgb, kRgb + 1, kRgb + 2};
  return layout;
}

}  // namespace quadrille::io
