#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille {

/// The places near measured points, within a region. Each view is a little off for the others, so
/// that two of them show a surface twice, some millimetres apart; what one view shows near the
/// points of another adds only errors.
class SurfaceCover {
 public:
  /// @param edge  points in cubes of this edge, and in those beside them, are near each other [m]
  SurfaceCover(const Eigen::AlignedBox3d& region_C, double edge);

  /// Covers the places near some points; those for which `left_out` is nonzero count for nothing.
  void add(const std::vector<Eigen::Vector3f>& points_C, const std::vector<std::uint8_t>& left_out);

  /// True if a place is near a point that was added; false outside the region.
  bool covers(const Eigen::Vector3f& p_C) const;

 private:
  void cover(const Eigen::Array3i& at);
  /// Returns where a place lies, in cubes from the corner of the region. It is not negative inside
  /// of the region, so that its whole part is the index of a cube.
  Eigen::Array3f cube_of(const Eigen::Vector3f& p_C) const {
    return (p_C - corner_C_).array() / edge_;
  }
  bool holds(const Eigen::Array3f& cube) const {
    return (cube >= 0.0f).all() && (cube < size_.cast<float>()).all();
  }
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * size_.y() + j) * size_.x() + i;
  }

  Eigen::Vector3f corner_C_ = Eigen::Vector3f::Zero();
  float edge_;
  Eigen::Array3i size_ = Eigen::Array3i::Zero();
  /// For each cube, whether it is near a point that was added, and whether it holds one.
  static constexpr char kNear = 1, kHolds = 2;
  std::vector<char> cubes_;
};

}  // namespace quadrille
