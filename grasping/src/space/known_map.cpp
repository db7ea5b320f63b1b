// Adds the space that a given OctoMap knows, and the robot's own space, to what the views show.
#include <octomap/OcTree.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "space/each_cube.hpp"
#include "space/outer_middles.hpp"
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

/// Tells which voxels of another lattice may hold middles of voxels in a cube of a map, which they
/// can do with their own middles outside of it.
class HeldMiddles {
 public:
  /// @param edge, other  edges of the voxels of the map and of the other lattice [m]
  HeldMiddles(const Eigen::AlignedBox3d& cube_M, const Eigen::Isometry3d& X_MC, double edge,
              double other)
      : middle_M_(cube_M.center()),
        half_M_((0.5 * (cube_M.sizes().array() - edge)).max(0.0)),
        R_CM_(X_MC.linear().transpose()),
        reach_M_(half_M_ + R_CM_.transpose().cwiseAbs().rowwise().sum() * (0.5 * other)),
        farthest_(0.5 * std::sqrt(3.0) * other),
        reach_C_((R_CM_.cwiseAbs() * half_M_).array() + 0.5 * other) {}

  /// True if the box of all middles and a voxel overlap along the axes of both, as they do if the
  /// voxel holds a middle.
  /// @param p_M  the voxel's middle
  bool may_be_in(const Eigen::Vector3d& p_M) const {
    const Eigen::Vector3d from_M = p_M - middle_M_;
    const Eigen::Vector3d beside_M = (from_M.cwiseAbs() - half_M_).cwiseMax(0.0);
    return beside_M.norm() <= farthest_ && (from_M.cwiseAbs().array() <= reach_M_.array()).all() &&
           ((R_CM_ * from_M).cwiseAbs().array() <= reach_C_.array()).all();
  }

 private:
  Eigen::Vector3d middle_M_, half_M_;
  Eigen::Matrix3d R_CM_;
  Eigen::Vector3d reach_M_;
  /// Half the diagonal of a voxel of the other lattice [m].
  double farthest_;
  Eigen::Vector3d reach_C_;
};

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
    const double edge = tree.getResolution(), reach = 0.5 * grid_.resolution();
    // The voxel at the middle of a small or turned one of the map may have its own middle
    // elsewhere. In a large cube of small voxels these are too many to ask each of them.
    const bool asks_own = occupied && edge < grid_.resolution() && leaf.getSize() > 1.5 * edge;
    std::optional<HeldMiddles> held;
    if (asks_own) held.emplace(cube_M, X_MC, edge, grid_.resolution());
    const Eigen::AlignedBox3d box_C = cube_M.transformed(map.X_CM);
    const double beside = asks_own ? reach : 0.0;
    each_voxel({box_C.min().array() - beside, box_C.max().array() + beside},
               [&](const Eigen::Vector3i& at) {
                 const Eigen::Vector3d p_M = X_MC * centre(at);
                 if (cube_M.contains(p_M) || (held && held->may_be_in(p_M))) mark(at);
               });
    if (!occupied || asks_own) continue;
    each_outer_middle(cube_M, region_M, edge, grid_.resolution(), [&](const Eigen::Vector3d& p_M) {
      const Eigen::Vector3d p_C = map.X_CM * p_M;
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
