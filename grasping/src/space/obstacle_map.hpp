#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

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
  /// both kinds, either may be returned, but always the same one for the same box. Only one thread
  /// may ask a map at a time.
  Hit collides(const OrientedBox& box) const;

  /// Frees all voxels whose centre lies within the body grown by `margin` [m], so that the target
  /// does not block its own grasp, except those for which keep(centre) holds.
  template <class Keep>
  void carve(const Body& body, double margin, Keep&& keep);

  /// Frees all voxels whose centre lies within `margin` [m] of one of the points, except those for
  /// which keep(centre) holds.
  template <class Keep>
  void carve(const std::vector<Eigen::Vector3d>& points_C, double margin, Keep&& keep);

  /// Frees all occupied voxels for which frees(centre) holds.
  template <class Frees>
  void free_occupied(Frees&& frees) {
    free_occupied([](const Eigen::Vector3d&, double) { return true; }, frees);
  }
  /// Does the same, and leaves out cubes for which may_free(middle, half edge [m]) is false.
  template <class MayFree, class Frees>
  void free_occupied(MayFree&& may_free, Frees&& frees);

  /// Frees unknown voxels that the sensor of a view could not see because the body stood in front
  /// of them.
  void clear_shadow(const Body& body, const Eigen::AlignedBox3d& region);

 private:
  static constexpr int kEdge = OccupancyGrid::kBlock;
  /// The cubes of the top level are the blocks of the grid.
  static constexpr int kLevels = std::bit_width(unsigned{OccupancyGrid::kBlock});
  /// Greatest number of points that free voxels together.
  static constexpr std::ptrdiff_t kTogether = 16;
  static constexpr std::uint8_t kAnyOccupied = 1, kAnyUnknown = 2, kAll = 4;

  /// The flags of the cubes of a block, level by level, from its voxels up to the block itself.
  struct Block {
    /// Index of the first cube of each level.
    static constexpr std::array<std::size_t, kLevels + 1> kFirst = [] {
      std::array<std::size_t, kLevels + 1> first{};
      for (unsigned n = 0; n < kLevels; ++n) {
        const std::size_t edge = unsigned{kEdge} >> n;
        first[n + 1] = first[n] + edge * edge * edge;
      }
      return first;
    }();
    std::array<std::uint8_t, kFirst[kLevels]> flags{};

    /// The first cube of a row of a level.
    std::uint8_t* row(int level, int j, int k) { return flags.data() + place(level, 0, j, k); }
    const std::uint8_t* row(int level, int j, int k) const {
      return flags.data() + place(level, 0, j, k);
    }
    static std::size_t place(int level, int i, int j, int k) {
      const std::size_t edge = unsigned{kEdge} >> static_cast<unsigned>(level);
      return kFirst[static_cast<std::size_t>(level)] +
             (static_cast<std::size_t>(k) * edge + static_cast<std::size_t>(j)) * edge +
             static_cast<std::size_t>(i);
    }
    bool is_empty() const { return flags.back() == 0; }
    /// Sets the flags of all larger cubes by those of the voxels.
    void refresh();
  };

  /// Returns the block of a voxel; nullptr if it holds nothing.
  const Block* block_of(const Eigen::Vector3i& voxel) const {
    const int n = number_of(voxel);
    return n < 0 ? nullptr : &blocks_.data()[n];
  }
  Block* block_of(const Eigen::Vector3i& voxel) {
    const int n = number_of(voxel);
    return n < 0 ? nullptr : &blocks_.data()[n];
  }
  /// Number of the block of a voxel; −1 if it holds nothing.
  int number_of(const Eigen::Vector3i& voxel) const { return numbers_.data()[block_index(voxel)]; }
  std::size_t block_index(const Eigen::Vector3i& voxel) const {
    const Eigen::Vector3i at = voxel / kEdge, size = size_ / kEdge;
    return (static_cast<std::size_t>(at.z()) * static_cast<std::size_t>(size.y()) +
            static_cast<std::size_t>(at.y())) *
               static_cast<std::size_t>(size.x()) +
           static_cast<std::size_t>(at.x());
  }
  void add(const Eigen::Vector3i& first, const Block& block);
  void add_all(const OccupancyGrid& grid);
  void add_occupied(const OccupancyGrid& grid);
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
  template <class Frees>
  bool free_occupied_in(Block& block, const Eigen::Vector3i& first, Frees&& frees);
  template <class Frees>
  void free_in(Block& block, const Eigen::Vector3i& first, const Range& range, Frees&& frees);
  Eigen::Vector3d centre(int i, int j, int k) const {
    return corner_ + resolution_ * (Eigen::Vector3d(i, j, k).array() + 0.5).matrix();
  }
  /// Offset of a cube's centre from a box's centre along six axes that may separate them, as
  /// floats; the last two elements are zero.
  using Offset = Eigen::Array<float, 8, 1>;
  struct Cube;
  std::uint8_t descend(const Query& query, const Cube& cube, const Offset& offset) const;
  bool refines(std::uint8_t flags) const;
  std::uint8_t meet(const Query& query, const Cube& cube) const;
  bool may_meet_last(const Range& range) const;
  Cube last() const;
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
  /// Number of voxels along x, y and z.
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  /// For each block of the grid, its number; negative if it holds nothing.
  std::vector<int> numbers_;
  std::vector<Block> blocks_;
  /// The cube that a box met last: its block, and the rest of its Cube.
  struct Met {
    int block = -1, level = 0;
    Eigen::Vector3i here = Eigen::Vector3i::Zero(), at = Eigen::Vector3i::Zero();
  };
  mutable Met last_;
};

/// Frees the voxels of a range for which frees(centre) holds. The larger cubes stay as they are.
template <class Frees>
void ObstacleMap::free(const Range& range, Frees&& frees) {
  const Eigen::Vector3i &low = range.first, &high = range.second;
  if ((high.array() < 0).any()) return;
  each_cube(low / kEdge * kEdge, high.array() + 1, kEdge, [&](const Eigen::Vector3i& first) {
    if (Block* block = block_of(first)) free_in(*block, first, range, frees);
  });
}

/// Frees such voxels of a block, given by its first voxel.
template <class Frees>
void ObstacleMap::free_in(Block& block, const Eigen::Vector3i& first, const Range& range,
                          Frees&& frees) {
  const Eigen::Vector3i low = (range.first - first).cwiseMax(0);
  const Eigen::Vector3i high = (range.second - first).cwiseMin(kEdge - 1);
  for (int k = low.z(); k <= high.z(); ++k) {
    for (int j = low.y(); j <= high.y(); ++j) {
      std::uint8_t* flags = block.row(0, j, k);
      // Most rows hold nothing.
      if (!any_set(flags + low.x(), high.x() - low.x() + 1)) continue;
      for (int i = low.x(); i <= high.x(); ++i) {
        if (flags[i] != 0 && frees(centre(first.x() + i, first.y() + j, first.z() + k))) {
          flags[i] = 0;
        }
      }
    }
  }
}

template <class MayFree, class Frees>
void ObstacleMap::free_occupied(MayFree&& may_free, Frees&& frees) {
  last_ = {};
  const double reach = 0.5 * kEdge * resolution_;
  each_cube(Eigen::Vector3i::Zero(), size_, kEdge, [&](const Eigen::Vector3i& first) {
    Block* block = block_of(first);
    if (block == nullptr || !(block->flags.back() & kAnyOccupied)) return;
    const Eigen::Array3d middle = first.cast<double>().array() + 0.5 * kEdge;
    if (!may_free(corner_ + resolution_ * middle.matrix(), reach)) return;
    if (free_occupied_in(*block, first, frees)) block->refresh();
  });
}

/// Frees such voxels of a block, given by its first voxel.
/// @return whether there were any
template <class Frees>
bool ObstacleMap::free_occupied_in(Block& block, const Eigen::Vector3i& first, Frees&& frees) {
  bool changed = false;
  for (int row = 0; row < kEdge * kEdge; ++row) {
    const int j = row % kEdge, k = row / kEdge;
    std::uint8_t* flags = block.row(0, j, k);
    if (!any_set(flags, kEdge)) continue;
    for (int i = 0; i < kEdge; ++i) {
      if (!(flags[i] & kAnyOccupied)) continue;
      if (!frees(centre(first.x() + i, first.y() + j, first.z() + k))) continue;
      flags[i] = 0;
      changed = true;
    }
  }
  return changed;
}

template <class Keep>
void ObstacleMap::carve(const Body& body, double margin, Keep&& keep) {
  Eigen::AlignedBox3d box = body.bounds_C();
  box.min().array() -= margin;
  box.max().array() += margin;
  const Range range = voxels(box);
  const Eigen::Isometry3d X_QC = body.X_CQ.inverse();
  free(range,
       [&](const Eigen::Vector3d& c) { return body.contains_Q(X_QC * c, margin) && !keep(c); });
  refresh(range);
}

template <class Keep>
void ObstacleMap::carve(const std::vector<Eigen::Vector3d>& points_C, double margin, Keep&& keep) {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(margin);
  Eigen::AlignedBox3d all;
  // Points that follow each other mostly lie side by side, and free almost the same voxels.
  for (auto first = points_C.begin(); first != points_C.end();) {
    Eigen::AlignedBox3d near(*first - reach, *first + reach);
    auto last = first;
    for (; last != points_C.end() && last - first < kTogether; ++last) {
      Eigen::AlignedBox3d more = near;
      more.extend(*last - reach).extend(*last + reach);
      if (more.sizes().maxCoeff() > 2.0 * margin + resolution_) break;
      near = more;
    }
    all.extend(near);
    free(voxels(near), [&](const Eigen::Vector3d& c) {
      const bool is_near = std::any_of(first, last, [&](const Eigen::Vector3d& p) {
        return (c - p).squaredNorm() <= margin * margin;
      });
      return is_near && !keep(c);
    });
    first = last;
  }
  if (!all.isEmpty()) refresh(voxels(all));
}

}  // namespace quadrille
