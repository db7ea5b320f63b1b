#include "space/surface_cover.hpp"

#include <algorithm>
#include <array>

#include "quadrille/detector/vector_clones.hpp"

namespace quadrille {
namespace {

// Number of points whose cubes are found at once.
constexpr std::size_t kPointsOfCover = 64;

/// Does for many coordinates what cube_of() does for one; −1 outside the region.
/// @param corners  the region's corner, as often as there are points
/// @param most  limits the numbers. As a constant it would keep the compiler from using vectors.
QUADRILLE_VECTOR_CLONES
void cubes_along(const float* values, const float* corners, std::size_t count, float edge,
                 float most, int* __restrict numbers) {
  for (std::size_t n = 0; n < count; ++n) {
    float x = (values[n] - corners[n]) / edge;
    // This is also false for missing coordinates.
    x = x >= 0.0f ? x : -1.0f;
    x = x < most ? x : -1.0f;
    numbers[n] = static_cast<int>(x);
  }
}

}  // namespace

SurfaceCover::SurfaceCover(const Eigen::AlignedBox3d& region_C, double edge)
    : edge_(static_cast<float>(edge)) {
  if (region_C.isEmpty()) return;
  corner_C_ = region_C.min().cast<float>();
  size_ = (region_C.sizes().array() / edge).ceil().cast<int>().max(1);
  cubes_.assign(static_cast<std::size_t>(size_.x()) * size_.y() * size_.z(), 0);
}

void SurfaceCover::add(const std::vector<Eigen::Vector3f>& points_C,
                       const std::vector<std::uint8_t>& left_out) {
  // No grid reaches so far.
  constexpr float kBeyond = 1e9f;
  const Eigen::Matrix<float, 3 * kPointsOfCover, 1> corners =
      corner_C_.replicate<kPointsOfCover, 1>();
  std::array<int, 3 * kPointsOfCover> numbers;
  for (std::size_t first = 0; first < points_C.size(); first += kPointsOfCover) {
    const std::size_t count = std::min(kPointsOfCover, points_C.size() - first);
    cubes_along(points_C[first].data(), corners.data(), 3 * count, edge_, kBeyond, numbers.data());
    // Unlike arrays and vectors, these do not check each access.
    const int* number = numbers.data();
    const std::uint8_t* left = left_out.data() + first;
    for (std::size_t n = 0; n < count; ++n, number += 3) {
      const int i = number[0], j = number[1], k = number[2];
      if (i < 0 || j < 0 || k < 0 || i >= size_.x() || j >= size_.y() || k >= size_.z()) continue;
      if (left[n] == 0) cover({i, j, k});
    }
  }
}

/// Covers the places near a point in a cube.
void SurfaceCover::cover(const Eigen::Array3i& at) {
  char& here = cubes_.data()[index(at.x(), at.y(), at.z())];
  // Several points lie in each cube.
  if ((here & kHolds) != 0) return;
  here |= kHolds;
  const Eigen::Array3i low = (at - 1).max(0), high = (at + 2).min(size_);
  for (int k = low.z(); k < high.z(); ++k) {
    for (int j = low.y(); j < high.y(); ++j) {
      char* beside = cubes_.data() + index(low.x(), j, k);
      for (int i = low.x(); i < high.x(); ++i) *beside++ |= kNear;
    }
  }
}

bool SurfaceCover::covers(const Eigen::Vector3f& p_C) const {
  const Eigen::Array3f cube = cube_of(p_C);
  if (!holds(cube)) return false;
  const Eigen::Array3i at = cube.cast<int>();
  return (cubes_[index(at.x(), at.y(), at.z())] & kNear) != 0;
}

}  // namespace quadrille
