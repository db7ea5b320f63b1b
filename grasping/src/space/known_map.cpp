// Adds the space that a given OctoMap knows, and the robot's own space, to what the views show.
#include <octomap/OcTree.h>

#include <cmath>

#include "space/each_cube.hpp"
#include "space/space_mapper.hpp"

namespace quadrille {
namespace {

octomap::point3d to_octomap(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

Eigen::Vector3d to_eigen(const octomap::point3d& p) { return {p.x(), p.y(), p.z()}; }

/// The part of a region, in the map's frame, that the tree can hold. OctoMap numbers voxels from
/// −32768 to 32767.
Eigen::AlignedBox3d within_tree(const Eigen::AlignedBox3d& region_M, const octomap::OcTree& tree) {
  const Eigen::Vector3d most = Eigen::Vector3d::Constant(32767.0 * tree.getResolution());
  return region_M.intersection(Eigen::AlignedBox3d(-most, most));
}

/// Calls visit(p) for the middles of the voxels in a cube of a map that may lie in a voxel of
/// another lattice with its middle outside of the cube.
/// @param region  only those in or beside it count
/// @param edge, other  edges of the voxels of both lattices [m]
template <class Visit>
void each_outer_middle(const Eigen::AlignedBox3d& cube, const Eigen::AlignedBox3d& region,
                       double edge, double other, Visit&& visit) {
  const Eigen::Array3d last = (cube.sizes().array() / edge).round().max(1.0) - 1.0;
  const Eigen::Array3d low = ((region.min() - cube.min()).array() / edge).floor().max(0.0);
  const Eigen::Array3d high = ((region.max() - cube.min()).array() / edge).floor().min(last);
  const double layers = std::ceil(0.5 * std::sqrt(3.0) * other / edge) + 1.0;
  if ((low > high).any()) return;
  each_cube(low.cast<int>(), high.cast<int>() + 1, 1, [&](const Eigen::Vector3i& voxel) {
    const Eigen::Array3d at = voxel.cast<double>().array();
    if ((at >= layers).all() && (at <= last - layers).all()) return;
    visit(Eigen::Vector3d(cube.min().array() + edge * (at + 0.5)));
  });
}

}  // namespace

/// Calls visit(at) for each voxel with its middle in the box.
template <class Visit>
void SpaceMapper::each_voxel(const Eigen::AlignedBox3d& box_C, Visit&& visit) {
  const auto numbers = [&](const Eigen::Vector3d& p_C) -> Eigen::Array3d {
    return p_C.array() / grid_.resolution() - grid_.corner().cast<double>().array() - 0.5;
  };
  const Eigen::Array3d last = grid_.size().cast<double>().array() - 1.0;
  const Eigen::Array3d low = numbers(box_C.min()).ceil().max(0.0);
  const Eigen::Array3d high = numbers(box_C.max()).floor().min(last);
  if ((low > high).any()) return;
  each_cube(low.cast<int>(), high.cast<int>() + 1, 1, visit);
}

bool SpaceMapper::add(const KnownMap& map) {
  const octomap::OcTree& tree = *map.tree;
  if (states_.empty() || tree.getRoot() == nullptr) return false;
  const Eigen::Isometry3d X_MC = map.X_CM.inverse();
  const Eigen::AlignedBox3d region_M = within_tree(grid_.bounds().transformed(X_MC), tree);
  if (region_M.isEmpty()) return false;
  bool any_occupied = false;
  const auto end = tree.end_leafs_bbx();
  for (auto leaf = tree.begin_leafs_bbx(to_octomap(region_M.min()), to_octomap(region_M.max()));
       leaf != end; ++leaf) {
    const bool occupied = tree.isNodeOccupied(*leaf);
    const Voxel state = occupied ? Voxel::kOccupied : Voxel::kFree;
    const auto mark = [&](const Eigen::Vector3i& at) {
      Voxel& here = voxel(at.x(), at.y(), at.z());
      if (here < state) here = state;
      if (occupied) occupied_[block_index(at)] = 1;
      any_occupied |= occupied;
    };
    const double half = 0.5 * leaf.getSize();
    const Eigen::Vector3d middle_M = to_eigen(leaf.getCoordinate());
    const Eigen::AlignedBox3d cube_M(middle_M.array() - half, middle_M.array() + half);
    each_voxel(cube_M.transformed(map.X_CM), [&](const Eigen::Vector3i& at) {
      if (cube_M.contains(X_MC * centre(at))) mark(at);
    });
    if (!occupied) continue;
    // The voxel at the middle of a small or turned one of the map may have its own middle
    // elsewhere.
    each_outer_middle(cube_M, region_M, tree.getResolution(), grid_.resolution(),
                      [&](const Eigen::Vector3d& p_M) {
                        const Eigen::Vector3d p_C = map.X_CM * p_M;
                        const double reach = 0.5 * grid_.resolution();
                        each_voxel({p_C.array() - reach, p_C.array() + reach}, mark);
                      });
  }
  return any_occupied;
}

void SpaceMapper::free_within(const NearShape& shape) {
  each_voxel(shape.bounds_C(), [&](const Eigen::Vector3i& at) {
    if (shape.contains(centre(at))) voxel(at.x(), at.y(), at.z()) = Voxel::kFree;
  });
}

}  // namespace quadrille
