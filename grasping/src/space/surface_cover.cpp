#include "space/surface_cover.hpp"

#include <algorithm>

#include "space/each_cube.hpp"

namespace quadrille {

SurfaceCover::SurfaceCover(const Eigen::AlignedBox3d& region_C, double edge)
    : edge_(static_cast<float>(edge)) {
  if (region_C.isEmpty()) return;
  corner_C_ = region_C.min().cast<float>();
  size_ = (region_C.sizes().array() / edge).ceil().cast<int>().max(1);
  cubes_.assign(static_cast<std::size_t>(size_.x()) * size_.y() * size_.z(), 0);
}

void SurfaceCover::add(const std::vector<Eigen::Vector3f>& points_C,
                       const std::vector<std::uint8_t>& left_out) {
  for (std::size_t n = 0; n < points_C.size(); ++n) {
    const Eigen::Array3f cube = cube_of(points_C[n]);
    if (left_out[n] || !holds(cube)) continue;
    const Eigen::Array3i at = cube.cast<int>();
    char& here = cubes_[index(at.x(), at.y(), at.z())];
    // Several points lie in each cube.
    if ((here & kHolds) != 0) continue;
    here |= kHolds;
    each_cube((at - 1).max(0).matrix(), (at + 2).min(size_).matrix(), 1,
              [&](const Eigen::Vector3i& beside) {
                cubes_[index(beside.x(), beside.y(), beside.z())] |= kNear;
              });
  }
}

bool SurfaceCover::covers(const Eigen::Vector3f& p_C) const {
  const Eigen::Array3f cube = cube_of(p_C);
  if (!holds(cube)) return false;
  const Eigen::Array3i at = cube.cast<int>();
  return (cubes_[index(at.x(), at.y(), at.z())] & kNear) != 0;
}

}  // namespace quadrille
