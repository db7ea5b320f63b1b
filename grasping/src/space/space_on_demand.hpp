#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "quadrille/grasping/occupancy.hpp"
#include "space/evidence.hpp"
#include "space/space_mapper.hpp"
#include "space/upward_steps.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

/// Decides the voxels of a grid when they are asked for. Hands come near few of them, so most need
/// never be decided.
///
/// Occupied voxels are known from the start. Free ones are sought for an eighth of a block at a
/// time, clear ones voxel by voxel down to what they stand on. All answers are those of
/// SpaceMapper::take_cleared(). Several threads may ask at once.
class OccupancyGrid::Source {
 public:
  /// @param mapper  knows all occupied voxels, and free ones that no view tells of
  /// @param views  the views that tell which others are free
  /// @param up_C  as in SpaceMapper::take_cleared(), for the first view
  /// @param evidence  what the occupied voxels are from
  Source(SpaceMapper mapper, std::shared_ptr<const std::vector<DepthView>> views,
         const Eigen::Vector3d& up_C, Evidence evidence);

  /// Returns the state of a voxel.
  Voxel at(const Eigen::Vector3i& voxel);
  /// Returns the states of all voxels, as OccupancyGrid::states().
  const std::vector<Voxel>& all();
  /// Tells which voxels are occupied, but not which of the others are free.
  const SpaceMapper& occupied() const { return mapper_; }
  const Evidence& evidence() const { return evidence_; }

 private:
  std::atomic<std::uint8_t>& decided(const Eigen::Vector3i& voxel);
  void decide(const Eigen::Vector3i& voxel);
  void settle(Eigen::Vector3i voxel);
  bool may_be_clear(const Eigen::Vector3i& voxel) const;

  SpaceMapper mapper_;
  std::shared_ptr<const std::vector<DepthView>> views_;
  Eigen::Vector3d up_C_;
  UpwardSteps up_;
  Evidence evidence_;
  /// Held by whoever decides or settles voxels.
  std::mutex mutex_;
  /// For each block, the eighths of which the free voxels are marked, a bit for each.
  std::vector<std::atomic<std::uint8_t>> decided_;
  std::once_flag once_;
  std::vector<Voxel> all_;
};

}  // namespace quadrille
