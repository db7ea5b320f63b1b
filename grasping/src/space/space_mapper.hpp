#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <utility>
#include <vector>

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
              std::vector<Eigen::AlignedBox3d> boxes_C = {}, int threads = 1)
      : grid_(region, resolution), boxes_C_(std::move(boxes_C)), threads_(threads) {}

  /// @param view  the view of that cloud
  /// @param left_out  nonzero for points that occupy no voxel
  /// @throws std::invalid_argument if view or marks are those of another cloud
  void add(const PointCloud& cloud, const DepthView& view,
           const std::vector<std::uint8_t>& left_out);
  /// Adds a view in which all points but strays occupy their voxels.
  void add(const PointCloud& cloud, const DepthView& view) { add(cloud, view, view.stray()); }

  /// Adds what a map from elsewhere says. Its occupied voxels count whatever the views saw, and its
  /// free ones only where no view tells. A voxel takes the state at its middle, and is occupied if
  /// an occupied voxel of the map has its middle in it.
  /// @return true if the map says of any voxel that it is occupied
  bool add(const KnownMap& map);

  /// Frees the voxels with their middle in or near a shape.
  void free_within(const NearShape& shape);

  /// Hands over the map of all views.
  OccupancyGrid take() && { return std::move(grid_); }
  /// Hands over the map after marking unknown voxels above free ones as clear: objects stand on a
  /// support, so one that reached up there would also be seen below. This applies only to voxels
  /// beside the image and at missing pixels, not to those hidden by a surface, since an object may
  /// overhang what stands in front of it.
  /// @param up_C  unit normal of the supporting plane; zero if there is none, which clears nothing
  OccupancyGrid take_cleared(const DepthView& view, const Eigen::Vector3d& up_C) &&;

 private:
  struct Tile;
  void mark_occupied(const PointCloud& cloud, const std::vector<std::uint8_t>& left_out);
  void mark_free(const DepthView& view);
  void mark_free(const DepthView& view, const Eigen::Vector3i& low, int edge);
  bool is_known(const Eigen::Vector3i& low, int edge) const;
  void mark_eighths(const DepthView& view, const Eigen::Vector3i& low, int edge,
                    const Eigen::Vector3d& p_V);
  void fill_free(const Eigen::Vector3i& low, int edge);
  bool wanted(const Eigen::Vector3i& block) const;
  template <class Visit>
  void each_voxel(const Eigen::AlignedBox3d& box_C, Visit&& visit);
  Eigen::Vector3d middle_V(const DepthView& view, const Eigen::Vector3i& low, int edge) const;
  bool is_clear(const DepthView& view, const Eigen::Vector3i& low, int edge) const;
  std::vector<Tile> tiles_beside(const DepthView& view) const;
  void clear_layer(const DepthView* view, const Tile& tile, int axis, const Eigen::Vector3i& up);
  Voxel& voxel(int i, int j, int k) { return grid_.states_[grid_.index(i, j, k)]; }

  OccupancyGrid grid_;
  std::vector<Eigen::AlignedBox3d> boxes_C_;
  int threads_;
};

}  // namespace quadrille
