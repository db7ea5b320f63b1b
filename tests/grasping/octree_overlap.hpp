#pragma once

#include <fcl/geometry/octree/octree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision.h>
#include <octomap/OcTree.h>

#include <memory>

#include "hand/oriented_box.hpp"

namespace quadrille::test {

/// FCL's own test of a box against the occupied cells of an octree: the reference for ObstacleMap.
inline bool overlaps(const OrientedBox& box, const std::shared_ptr<const octomap::OcTree>& tree) {
  if (!tree || !tree->getRoot()) return false;
  fcl::OcTreed cells(tree);
  cells.computeLocalAABB();
  const fcl::Boxd solid(2.0 * box.half);
  fcl::Transform3d X = fcl::Transform3d::Identity();
  X.linear() = box.R_CB;
  X.translation() = box.p_CB;
  fcl::CollisionRequestd request(1, false);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.gjk_tolerance = 1e-6;
  fcl::CollisionResultd result;
  return fcl::collide(&cells, fcl::Transform3d::Identity(), &solid, X, request, result) > 0;
}

}  // namespace quadrille::test
