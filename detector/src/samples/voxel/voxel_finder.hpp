#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "samples/plane_moments.hpp"
#include "samples/voxel/voxel_grid.hpp"

namespace quadrille {

/// Finds the voxels around one point after another. The bricks around are gathered once for all
/// points in a brick, so that going through the voxels in their order is fast: for the sums and
/// neighbours of all voxels, a k-d tree (nanoflann) takes three to four times as long.
class VoxelFinder {
 public:
  /// @param radius  radius of all balls [m]
  /// @param keep    voxels to find
  VoxelFinder(const VoxelGrid& grid, float radius, std::span<const char> keep = {});

  /// Returns the voxels whose means lie within the radius of p. Their order depends only on the
  /// grid and on the brick of p.
  const std::vector<int>& within(const Eigen::Vector3f& p);

  /// Sums over the offsets from p of those voxels' means that lie within the radius.
  /// @param reach      radius within which voxels count as near [m]
  /// @param max_count  largest number of near voxels to find
  /// @param nearest    receives the voxels nearest to p, including the one whose mean is p
  PlaneMoments moments(const Eigen::Vector3f& p, float reach, int max_count,
                       std::vector<int>* nearest);

 private:
  void gather_around(const Eigen::Vector3f& p);
  void find_bricks(int x, int y, int z);
  void find_among_all(int x, int y, int z);
  int collect_near(int runs);

  const VoxelGrid& grid_;
  std::span<const char> keep_;
  float radius_;
  int reach_;
  std::uint64_t home_;
  std::vector<const VoxelGrid::Brick*> bricks_;
  /// The voxels of the bricks around the brick `home_`, padded with infinitely distant ones.
  std::vector<int> voxel_;
  std::vector<float> x_, y_, z_;
  /// Squared distances of these voxels; starts of the runs that contain near voxels; and bit masks
  /// of the near voxels in them.
  std::vector<float> distance_;
  std::vector<int> run_;
  std::vector<unsigned> bits_;
  /// The near voxels: squared distances, indices, and number of nearer ones.
  std::vector<float> near_distance_;
  std::vector<int> near_voxel_, rank_;
  std::vector<int> within_;
};

}  // namespace quadrille
