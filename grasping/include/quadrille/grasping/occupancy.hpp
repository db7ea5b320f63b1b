#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace octomap {
class OcTree;
}

namespace quadrille {

class DepthView;

/// State of one voxel, the stronger evidence last. Clear ones were not seen, but lie over free
/// space (see OccupancyGrid::clear_above); octrees leave them out, like unknown ones.
enum class Voxel : std::uint8_t { kUnknown, kClear, kFree, kOccupied };

/// Free, occupied and unknown space of a region, as one dense grid of voxels.
///
/// A voxel that holds a point is occupied; one that every ray through it was seen to pass is free;
/// the rest (behind a surface, outside the image, at missing pixels) is unknown. Voxel (i, j, k)
/// covers [i, i + 1) × … times the resolution, counted from a corner on OctoMap's own lattice.
class OccupancyGrid {
 public:
  /// Voxels per edge of the blocks that the grid is made of.
  static constexpr int kBlock = 16;
  /// Voxels that a grid has at most: 32 MB.
  static constexpr double kMaxVoxels = 32 << 20;
  /// Voxels from the origin of C that it reaches at most. OctoMap numbers them from −32768 to
  /// 32767; the blocks at the ends need some room.
  static constexpr double kMaxCoordinate = 32000.0;

  /// Unknown space.
  /// @param region      space to map, in frame C [m]; grown to whole blocks
  /// @param resolution  voxel edge [m]
  /// @throws std::invalid_argument if the resolution is not positive, the region leaves OctoMap's
  ///         range of ±32768 voxels, or it has more than kMaxVoxels
  QUADRILLE_EXPORT OccupancyGrid(const Eigen::AlignedBox3d& region, double resolution);
  /// What one view shows of it.
  QUADRILLE_EXPORT OccupancyGrid(const PointCloud& cloud, const DepthView& view,
                                 const Eigen::AlignedBox3d& region, double resolution);

  /// Looks for free space only in blocks that meet one of these boxes from now on, to save time;
  /// the others stay unknown but for the points in them.
  void restrict_to(std::vector<Eigen::AlignedBox3d> boxes_C) { boxes_C_ = std::move(boxes_C); }
  /// Adds what another view of the same scene shows. What any view found occupied stays so; what
  /// any saw through is free.
  /// @param view  the view of that cloud
  /// @throws std::invalid_argument if it is that of another one
  QUADRILLE_EXPORT void add(const PointCloud& cloud, const DepthView& view);

  /// Marks unknown voxels over free ones as clear: things stand, and what would reach up there
  /// would be seen below. Only voxels beside the image and at missing pixels, not what a surface
  /// hides: a thing may overhang what stands before it.
  /// @param up_C  unit normal of the plane that things stand on
  QUADRILLE_EXPORT void clear_above(const DepthView& view, const Eigen::Vector3d& up_C);

  double resolution() const { return resolution_; }
  /// Voxels along x, y and z; zero for an empty region.
  const Eigen::Vector3i& size() const { return size_; }
  /// Corner of voxel (0, 0, 0), in voxels from the origin of C.
  const Eigen::Vector3i& corner() const { return corner_; }
  /// The space that it covers, in frame C [m].
  QUADRILLE_EXPORT Eigen::AlignedBox3d bounds() const;
  /// State at a point of C; unknown outside.
  QUADRILLE_EXPORT Voxel at(const Eigen::Vector3d& p_C) const;
  Voxel at(int i, int j, int k) const { return states_[index(i, j, k)]; }
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * size_.y() + j) * size_.x() + i;
  }
  /// Centre of a voxel in frame C [m].
  Eigen::Vector3d centre(int i, int j, int k) const {
    return ((corner_ + Eigen::Vector3i(i, j, k)).cast<double>().array() + 0.5) * resolution_;
  }
  const std::vector<Voxel>& states() const { return states_; }

  /// The same space in frame F, of the same resolution, or of a coarser one where it would have
  /// more than kMaxVoxels. Where its lattice is turned a voxel meets several of this one, and is
  /// what the most cautious of them is: occupied if any is, free only if all are.
  /// @throws std::invalid_argument if the region then leaves OctoMap's range
  QUADRILLE_EXPORT OccupancyGrid moved(const Eigen::Isometry3d& X_FC) const;

  /// The same map as an OctoMap, uniform blocks as single nodes; unknown where it has no node.
  QUADRILLE_EXPORT std::shared_ptr<octomap::OcTree> to_octree() const;

 private:
  void mark_free(const DepthView& view);
  void mark_free(const DepthView& view, const Eigen::Vector3i& low, int edge);
  void mark_eight(const DepthView& view, const Eigen::Vector3i& low, const Eigen::Vector3d& p_V);
  void mark_occupied(const PointCloud& cloud, const std::vector<std::uint8_t>& stray);
  struct Tile;
  std::vector<Tile> tiles_beside(const DepthView& view) const;
  void divide(const DepthView& view, const Eigen::Vector3i& block, std::vector<Tile>& tiles) const;
  void clear_layer(const DepthView* view, const Tile& tile, int axis, const Eigen::Vector3i& up);
  bool wanted(const Eigen::Vector3i& block) const;
  Voxel most_cautious(const Eigen::AlignedBox3d& box_C) const;
  void fill_free(const Eigen::Vector3i& low, int edge);

  double resolution_ = 0.0;
  Eigen::Vector3i corner_ = Eigen::Vector3i::Zero(), size_ = Eigen::Vector3i::Zero();
  std::vector<Voxel> states_;
  /// None: everywhere.
  std::vector<Eigen::AlignedBox3d> boxes_C_;
};

}  // namespace quadrille
