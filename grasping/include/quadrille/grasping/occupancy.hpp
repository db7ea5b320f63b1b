#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/word.hpp"

namespace octomap {
class OcTree;
}

namespace quadrille {

/// State of one voxel, in order of increasing evidence. Clear voxels were not seen, but lie above
/// free space, where anything would stand in view (planner.clear_above); octrees leave them out,
/// like unknown ones.
enum class Voxel : std::uint8_t { kUnknown, kClear, kFree, kOccupied };

constexpr auto words_of(Voxel) {
  return std::to_array<Word<Voxel>>({{"unknown", Voxel::kUnknown},
                                     {"clear", Voxel::kClear},
                                     {"free", Voxel::kFree},
                                     {"occupied", Voxel::kOccupied}});
}

/// A dense voxel grid of free, occupied and unknown space in a region.
///
/// A voxel is occupied if it holds a point, free if every ray through it was seen to pass, and
/// unknown otherwise (behind a surface, outside the image, at missing pixels). GraspPlan::space
/// holds the grid of a plan; most of its voxels are decided when they are asked for by place, so
/// the first look at all of them takes longer. Until it is destroyed, such a grid keeps the depths
/// that the views saw. Voxel (i, j, k) covers [i, i + 1) × … times the resolution, counted from a
/// corner on OctoMap's own lattice.
class OccupancyGrid {
 public:
  /// Edge length of the blocks that make up the grid, in voxels.
  static constexpr int kBlock = 16;
  /// Largest number of voxels in a grid: 32 MB.
  static constexpr double kMaxVoxels = 32 << 20;
  /// Largest distance between a voxel and the origin of C, in voxels. OctoMap numbers voxels from
  /// −32768 to 32767, and the blocks at the ends need some room.
  static constexpr double kMaxCoordinate = 32000.0;

  /// Makes a grid of unknown space.
  /// @param region      space to map, in frame C [m]; grown to whole blocks
  /// @param resolution  voxel edge [m]
  /// @throws std::invalid_argument if the resolution is not positive, the region leaves OctoMap's
  ///         range of ±32768 voxels, or it has more than kMaxVoxels
  QUADRILLE_EXPORT OccupancyGrid(const Eigen::AlignedBox3d& region, double resolution);

  double resolution() const { return resolution_; }
  /// Number of voxels along x, y and z; zero for an empty region.
  const Eigen::Vector3i& size() const { return size_; }
  /// Corner of voxel (0, 0, 0), counted in voxels from the origin of C.
  const Eigen::Vector3i& corner() const { return corner_; }
  /// The space that the grid covers, in frame C [m].
  QUADRILLE_EXPORT Eigen::AlignedBox3d bounds() const;
  /// State at a point in frame C; unknown outside the grid.
  QUADRILLE_EXPORT Voxel at(const Eigen::Vector3d& p_C) const;
  /// Decides all voxels first.
  Voxel at(int i, int j, int k) const { return states()[index(i, j, k)]; }
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * size_.y() + j) * size_.x() + i;
  }
  /// Centre of a voxel in frame C [m].
  Eigen::Vector3d centre(int i, int j, int k) const {
    return ((corner_ + Eigen::Vector3i(i, j, k)).cast<double>().array() + 0.5) * resolution_;
  }
  const std::vector<Voxel>& states() const { return source_ ? all_of_source() : states_; }

  /// Makes the grid in frame F. The resolution stays the same, but is coarser if the grid would
  /// otherwise exceed kMaxVoxels. If the lattice is rotated, a voxel overlaps several old ones and
  /// takes their most cautious state: free only if all are, and occupied if any is. The grid of a
  /// plan knows its points; there a voxel is occupied only if it holds one, as in C, and unknown if
  /// it holds none but overlaps an occupied one.
  /// @throws std::invalid_argument if the region then leaves OctoMap's range
  QUADRILLE_EXPORT OccupancyGrid moved(const Eigen::Isometry3d& X_FC) const;

  /// Converts the grid to an OctoMap in which uniform blocks are single nodes; space without a node
  /// is unknown.
  QUADRILLE_EXPORT std::shared_ptr<octomap::OcTree> to_octree() const;

 private:
  friend class SpaceMapper;
  friend class ObstacleMap;
  /// Decides voxels when they are asked for.
  class Source;
  /// The points, map and shapes from which the occupied voxels were made.
  struct Evidence;

  OccupancyGrid() = default;
  /// Makes the grid without any states, which must be added.
  static OccupancyGrid without_states(const Eigen::AlignedBox3d& region, double resolution);
  OccupancyGrid resampled(const Eigen::Isometry3d& X_FC) const;
  QUADRILLE_EXPORT const std::vector<Voxel>& all_of_source() const;

  double resolution_ = 0.0;
  Eigen::Vector3i corner_ = Eigen::Vector3i::Zero(), size_ = Eigen::Vector3i::Zero();
  std::vector<Voxel> states_;
  /// Set if the voxels are decided on demand; there are no states then.
  std::shared_ptr<Source> source_;
};

}  // namespace quadrille
