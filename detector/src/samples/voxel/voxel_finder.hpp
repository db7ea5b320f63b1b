#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "samples/plane_moments.hpp"
#include "samples/voxel/voxel_grid.hpp"

namespace quadrille {

/// Finds the voxels around one point after another. The bricks around are gathered once for all
/// points of a brick, so that going from voxel to voxel in their order is fast.
class VoxelFinder {
 public:
  /// @param radius  of all balls [m]
  /// @param keep    per voxel, zero to leave it out; empty means all
  VoxelFinder(const VoxelGrid& grid, float radius, std::span<const char> keep = {});

  /// The voxels whose means lie within the radius of p, in an order that depends on the grid and
  /// the brick of p alone.
  const std::vector<int>& within(const Eigen::Vector3f& p);

  /// Sums over the offsets from p of the voxels' means within the radius.
  /// @param reach      radius of what is near [m]
  /// @param max_count  voxels to find there at most
  /// @param nearest    gets the voxels nearest to p, also the one whose mean p is
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
  /// The voxels of the bricks around the brick `home_`, filled up with some infinitely far.
  std::vector<int> voxel_;
  std::vector<float> x_, y_, z_;
  /// Squared distances of these; where runs of them start some of which are near, and which.
  std::vector<float> distance_;
  std::vector<int> run_;
  std::vector<unsigned> bits_;
  /// The near ones: squared distances, voxels, and how many are nearer.
  std::vector<float> near_distance_;
  std::vector<int> near_voxel_, rank_;
  std::vector<int> within_;
};

}  // namespace quadrille
