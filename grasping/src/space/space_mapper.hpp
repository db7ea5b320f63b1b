#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/zeroed_vector.hpp"
#include "quadrille/detector/near_shape.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/surroundings.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

/// Maps the space that views of one static scene show. A voxel that any view found occupied is
/// occupied; otherwise, one that any view saw through is free. The order of the views does not
/// matter.
class SpaceMapper {
 public:
  /// The region and the resolution are those of OccupancyGrid, with the same errors.
  /// @param boxes_C  to save time, free space is sought only in blocks that meet one of these
  ///   boxes; all others stay unknown, except for voxels that contain points. No boxes: everywhere.
  /// @param threads  number of threads that mark free space; it never changes the map
  SpaceMapper(const Eigen::AlignedBox3d& region, double resolution,
              std::vector<Eigen::AlignedBox3d> boxes_C = {}, int threads = 1);

  /// @param view  the view of that cloud
  /// @param left_out  nonzero for points that occupy no voxel
  /// @throws std::invalid_argument if view or marks are those of another cloud
  void add(const PointCloud& cloud, const DepthView& view,
           const std::vector<std::uint8_t>& left_out);
  /// Adds a view in which all points but strays occupy their voxels.
  void add(const PointCloud& cloud, const DepthView& view) { add(cloud, view, view.stray()); }

  /// Adds the points of a view, but not the space that it saw through.
  /// @throws std::invalid_argument if the marks are those of another cloud
  void add_points(const PointCloud& cloud, const std::vector<std::uint8_t>& left_out);

  /// Adds what a map from elsewhere says. Its occupied voxels count whatever the views saw, and its
  /// free ones only where no view tells. A voxel takes the state at its middle, and is occupied if
  /// an occupied voxel of the map has its middle in it.
  /// @return true if the map says of any voxel that it is occupied
  bool add(const KnownMap& map);

  /// Frees the voxels with their middle in or near a shape.
  void free_within(const NearShape& shape);

  /// Hands over the map of all views.
  OccupancyGrid take() &&;
  /// Hands over the map after marking unknown voxels above free ones as clear: objects stand on a
  /// support, so one that reached up there would also be seen below. This applies only to voxels
  /// beside the image and at missing pixels, not to those hidden by a surface, since an object may
  /// overhang what stands in front of it.
  /// @param up_C  unit normal of the supporting plane; zero if there is none, which clears nothing
  OccupancyGrid take_cleared(const DepthView& view, const Eigen::Vector3d& up_C) &&;
  /// Hands over the map that take_cleared() would give after the views were added, of which only
  /// the points were. Its free and clear voxels are decided when they are asked for.
  /// @param views  all views; the first one tells which voxels are clear
  /// @param evidence  all that was added
  OccupancyGrid take_on_demand(std::shared_ptr<const std::vector<DepthView>> views,
                               const Eigen::Vector3d& up_C, OccupancyGrid::Evidence evidence) &&;

  // The parts from which the map is made on demand:

  const Eigen::Vector3i& size() const { return grid_.size(); }
  double resolution() const { return grid_.resolution(); }
  Eigen::AlignedBox3d bounds() const { return grid_.bounds(); }
  /// Centre of a voxel in frame C [m].
  Eigen::Vector3d centre(const Eigen::Vector3i& at) const {
    return grid_.centre(at.x(), at.y(), at.z());
  }
  Voxel& voxel(int i, int j, int k) { return states_.data()[grid_.index(i, j, k)]; }
  const Voxel& voxel(int i, int j, int k) const { return states_.data()[grid_.index(i, j, k)]; }
  /// Number of blocks, and the index of the block of a voxel.
  std::size_t blocks() const { return states_.size() / kBlock / kBlock / kBlock; }
  std::size_t block_index(const Eigen::Vector3i& at) const {
    const Eigen::Vector3i block = at / kBlock, size = grid_.size() / kBlock;
    return (static_cast<std::size_t>(block.z()) * size.y() + block.y()) * size.x() + block.x();
  }
  /// Returns true if free space is sought in a block, given by its first voxel.
  bool wanted(const Eigen::Vector3i& block) const;
  /// Marks the free voxels of some eighths of a block.
  /// @param eighths  bit n is set for the eighth eighth_of_cube(n)
  void mark_free(const DepthView& view, const Eigen::Vector3i& block, unsigned eighths);
  static constexpr unsigned kAllEighths = 0xff;
  /// Marks the free voxels of all wanted blocks, except those that are marked already.
  /// @param marked  nonzero for such blocks, by index; empty if there are none
  void mark_free(const DepthView& view, const std::vector<char>& marked);
  /// Returns false if the image shows that all voxels of a block are free, or that all are hidden.
  bool is_beside(const DepthView& view, const Eigen::Vector3i& block) const;
  /// Replaces one state by another everywhere.
  void replace(Voxel old_state, Voxel new_state);
  /// Returns the first voxels of the blocks that may have occupied ones.
  std::vector<Eigen::Vector3i> occupied_blocks() const;

 private:
  struct Tile;
  void mark_occupied(const PointCloud& cloud, const std::vector<std::uint8_t>& left_out);
  static constexpr int kBlock = OccupancyGrid::kBlock;
  bool is_known(const Eigen::Vector3i& low, int edge) const;
  void mark_eighths(const DepthView& view, const Eigen::Vector3i& low, int edge,
                    const Eigen::Vector3d& p_V, unsigned eighths);
  void fill_free(const Eigen::Vector3i& low, int edge);
  template <class Visit>
  void each_voxel(const Eigen::AlignedBox3d& box_C, Visit&& visit);
  Eigen::Vector3d middle_V(const DepthView& view, const Eigen::Vector3i& low, int edge) const;
  bool is_clear(const DepthView& view, const Eigen::Vector3i& low, int edge) const;
  std::vector<Tile> tiles_beside(const DepthView& view) const;
  void clear_layer(const DepthView* view, const Tile& tile, int axis, const Eigen::Vector3i& up);

  /// The geometry of the map; the states are added when it is taken.
  OccupancyGrid grid_;
  ZeroedVector<Voxel> states_;
  /// For each block, nonzero if it may have occupied voxels.
  std::vector<char> occupied_;
  std::vector<Eigen::AlignedBox3d> boxes_C_;
  int threads_;
};

}  // namespace quadrille
