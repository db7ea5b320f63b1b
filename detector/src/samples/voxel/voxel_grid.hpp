#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// Sparse grid of cubic voxels with the mean of the points in each. Bricks of 4 x 4 x 4 voxels lie
/// in a hash table. A 64-bit word marks the voxels of a brick that hold points, and the number of
/// bits before a voxel's own is its position among them. The voxels of a brick are consecutive, and
/// bricks that are near in space mostly are near in memory.
class VoxelGrid {
 public:
  /// Makes the voxels that contain the points; points that are not finite are left out.
  /// @param weight    positive number of points that each one stands for; empty for one each
  /// @param edge      edge of a voxel [m], positive. Points more than a million voxels from the
  ///   origin share the outermost voxels
  /// @param of_point  if given, receives the voxel of each point; -1 if not finite
  VoxelGrid(std::span<const Eigen::Vector3f> points, std::span<const int> weight, float edge,
            std::vector<int>* of_point = nullptr);

  int size() const { return static_cast<int>(mean_.size()); }
  float edge() const { return edge_; }
  /// Mean of the points in each voxel [m].
  const std::vector<Eigen::Vector3f>& mean() const { return mean_; }
  /// Number of points in each voxel.
  const std::vector<int>& count() const { return count_; }
  /// The voxel that contains a point [m]; −1 if it is not in the grid.
  int voxel_of(const Eigen::Vector3f& point) const;

 private:
  friend class VoxelFinder;

  struct Brick {
    std::uint64_t key = 0, filled = 0;
    /// The voxels of the brick are first … first + size - 1.
    int first = 0, size = 0;

    /// The voxel of one of the brick's bits, which must be set.
    int voxel(int bit) const;
  };
  /// The brick of a point, and the bit of its voxel.
  struct Place {
    std::uint64_t key;
    int bit;
  };

  static constexpr std::uint64_t kNoKey = ~std::uint64_t{0};
  // Coordinates have 21 bits.
  static constexpr double kMaxCoordinate = (1 << 20) - 1;

  /// Index of a voxel along an axis, shifted to be positive; distant points share the outermost.
  std::uint32_t coordinate(float x) const {
    const double c = static_cast<double>(x) * inverse_;
    return static_cast<std::uint32_t>(std::clamp(c, -kMaxCoordinate, kMaxCoordinate) +
                                      kMaxCoordinate);
  }
  Place place_of(const Eigen::Vector3f& p) const {
    const std::uint32_t x = coordinate(p.x()), y = coordinate(p.y()), z = coordinate(p.z());
    return {key_of(x / 4, y / 4, z / 4), static_cast<int>(x % 4 + 4 * (y % 4) + 16 * (z % 4))};
  }
  std::size_t slot_of(std::uint64_t key) const {
    // Fibonacci hashing: the topmost bits of the product depend on all of the key's.
    return key * 0x9e3779b97f4a7c15u >> (64 - std::countr_zero(slots_.size()));
  }
  static std::uint64_t key_of(std::uint32_t bx, std::uint32_t by, std::uint32_t bz) {
    return bx | static_cast<std::uint64_t>(by) << 21 | static_cast<std::uint64_t>(bz) << 42;
  }
  /// Returns the brick with this key; null if no point lies in it.
  const Brick* find(std::uint64_t key) const;
  /// Box that contains all points that lie no farther than the margin [m] from a brick.
  Eigen::AlignedBox3f box_of_brick(int bx, int by, int bz, float margin) const;
  int find_or_add(std::uint64_t key);
  void rehash(std::size_t slots);
  /// Numbers the voxels along a curve, whatever the order of the points, and returns their count.
  int number_voxels();

  float edge_;
  double inverse_;
  std::vector<Brick> bricks_;
  /// Indices of bricks in a hash table with open addressing; -1 for empty slots. Their number is a
  /// power of two, which doubles as bricks are added.
  std::vector<int> slots_;
  std::vector<Eigen::Vector3f> mean_;
  std::vector<int> count_;
};

}  // namespace quadrille
