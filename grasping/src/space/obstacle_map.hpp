#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "base/zeroed_vector.hpp"
#include "body/body.hpp"
#include "hand/oriented_box.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "space/each_cube.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

/// The kinds of space that a box runs into.
enum class Hit : std::uint8_t { kNone, kOccupied, kUnknown };

/// The voxels of a grid that a hand must not enter, with a pyramid over them for fast box tests.
///
/// collides() runs in the live path; it tests separating axes against blocks, then voxels. FCL's
/// collide() on the octree of the same grid gives the same answers (the tests compare them), but
/// takes several times as long (measured: 17-27 µs against 4 µs for a hand of three boxes) and
/// cannot see unknown space.
class ObstacleMap {
 public:
  /// If views are given, the voxels that a box overlaps are divided, and the box passes the parts
  /// that a view saw through: eighths of an occupied voxel, and eighths of those for an unknown
  /// one. Occupied voxels are divided only if there is one view, since the points of each view are
  /// a little off for the others. This matters at the edge of a shadow, where a whole voxel is
  /// unknown even if only a little of it was hidden.
  /// @param unknown_blocks  if true, unknown voxels and all space outside the grid are obstacles
  ///   too
  /// @param views  they must outlive this map and its copies
  /// @param divide_occupied  false if the grid has occupied voxels that are not from these views
  ObstacleMap(const OccupancyGrid& grid, bool unknown_blocks, std::span<const DepthView> views = {},
              bool divide_occupied = true);

  /// Copies the blocks of the map that the region meets, so that they can be carved at little cost.
  /// All space beyond them counts as outside.
  ObstacleMap within(const Eigen::AlignedBox3d& region) const;

  /// Returns true if a point lies in a voxel that is occupied and was not freed.
  bool is_occupied(const Eigen::Vector3d& p_C) const;

  /// Returns what the box overlaps; touching without overlap does not count. If the box overlaps
  /// both kinds, either may be returned, but always the same one for the same box.
  Hit collides(const OrientedBox& box) const;

  /// Frees all voxels whose centre lies within the body grown by `margin` [m], so that the target
  /// does not block its own grasp, except those for which keep(centre) holds.
  template <class Keep>
  void carve(const Body& body, double margin, Keep&& keep);

  /// Frees all voxels whose centre lies within `margin` [m] of one of the points, except those for
  /// which keep(centre) holds.
  template <class Keep>
  void carve(const std::vector<Eigen::Vector3d>& points_C, double margin, Keep&& keep);

  /// Frees unknown voxels that the sensor of a view could not see because the body stood in front
  /// of them.
  void clear_shadow(const Body& body, const Eigen::AlignedBox3d& region);

 private:
  /// The cubes of the top level are the blocks of the grid.
  static constexpr int kLevels = std::bit_width(unsigned{OccupancyGrid::kBlock});
  static constexpr std::uint8_t kAnyOccupied = 1, kAnyUnknown = 2, kAll = 4;
  struct Level {
    Eigen::Vector3i size;
    ZeroedVector<std::uint8_t> flags;
    std::size_t index(int i, int j, int k) const {
      return (static_cast<std::size_t>(k) * size.y() + j) * size.x() + i;
    }
  };
  static void copy_cubes(const Level& from, const Eigen::Vector3i& block,
                         const Eigen::Vector3i& low, int level, Level& to);
  void mark_all(const OccupancyGrid& grid);
  void mark_occupied(const OccupancyGrid& grid);
  struct Query;
  struct Cone;
  using Range = std::pair<Eigen::Vector3i, Eigen::Vector3i>;

  /// Returns true if one of some bytes in a row is not zero.
  static bool any_set(const std::uint8_t* bytes, int count) {
    std::uint32_t any = 0, four = 0;
    // Four bytes at once; the last four may overlap those before them.
    for (int i = 0; count >= 4 && i < count; i += 4) {
      std::memcpy(&four, bytes + std::min(i, count - 4), sizeof(four));
      any |= four;
    }
    for (int i = 0; count < 4 && i < count; ++i) any |= bytes[i];
    return any != 0;
  }
  Range voxels(const Eigen::AlignedBox3d& box) const;
  template <class Frees>
  void free(const Range& range, Frees&& frees);
  Eigen::Vector3d centre(int i, int j, int k) const {
    return corner_ + resolution_ * (Eigen::Vector3d(i, j, k).array() + 0.5).matrix();
  }
  /// Offset of a cube's centre from a box's centre along six axes that may separate them, as
  /// floats; the last two elements are zero.
  using Offset = Eigen::Array<float, 8, 1>;
  std::uint8_t descend(const Query& query, int level, const Eigen::Vector3i& at,
                       const Offset& offset) const;
  bool enters_hidden(const Query& query, const Eigen::Vector3d& centre, double half, int depth,
                     double margin) const;
  void clear_shadow(const DepthView& view, const Body& body, const Range& blocks);
  void clear_block(const DepthView& view, const Body& body, const Cone& cone,
                   const Eigen::Vector3i& first);
  void refresh(const Range& range);

  ObstacleMap() = default;

  double resolution_ = 0.0;
  bool unknown_blocks_ = false;
  /// Whether the parts of occupied voxels are told apart.
  bool divide_occupied_ = false;
  std::span<const DepthView> views_;
  Eigen::Vector3d corner_;
  std::array<Level, kLevels> levels_;
};

/// Frees the voxels of a range for which frees(centre) holds. The pyramid over them stays as it is.
template <class Frees>
void ObstacleMap::free(const Range& range, Frees&& frees) {
  const Eigen::Vector3i &first = range.first, &last = range.second;
  for (int k = first.z(); k <= last.z(); ++k) {
    for (int j = first.y(); j <= last.y(); ++j) {
      // Unlike vectors, this does not check each access.
      std::uint8_t* flags = levels_[0].flags.data() + levels_[0].index(0, j, k);
      // Most rows hold nothing.
      if (!any_set(flags + first.x(), last.x() - first.x() + 1)) continue;
      for (int i = first.x(); i <= last.x(); ++i) {
        if (flags[i] != 0 && frees(centre(i, j, k))) flags[i] = 0;
      }
    }
  }
}

template <class Keep>
void ObstacleMap::carve(const Body& body, double margin, Keep&& keep) {
  Eigen::AlignedBox3d box = body.bounds_C();
  box.min().array() -= margin;
  box.max().array() += margin;
  const Range range = voxels(box);
  free(range, [&](const Eigen::Vector3d& c) { return body.contains(c, margin) && !keep(c); });
  refresh(range);
}

template <class Keep>
void ObstacleMap::carve(const std::vector<Eigen::Vector3d>& points_C, double margin, Keep&& keep) {
  Eigen::AlignedBox3d all;
  for (const Eigen::Vector3d& p : points_C) {
    const Eigen::AlignedBox3d near(p.array() - margin, p.array() + margin);
    all.extend(near);
    free(voxels(near), [&](const Eigen::Vector3d& c) {
      return (c - p).squaredNorm() <= margin * margin && !keep(c);
    });
  }
  if (!all.isEmpty()) refresh(voxels(all));
}

}  // namespace quadrille
