#include "quadrille/grasping/collision.hpp"

#include <fcl/fcl.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

// Only collide(), never distance() or continuousCollide(): those fail on half-spaces and empty
// octrees or miss thin walls between their samples. libccd's solver, not FCL's own (GST_INDEP),
// which lets a small box inside a Convex pass.
bool fcl_collide(const fcl::CollisionGeometryd* a, const fcl::Transform3d& X_A,
                 const fcl::CollisionGeometryd* b, const fcl::Transform3d& X_B) {
  fcl::CollisionRequestd request(1, false);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.gjk_tolerance = 1e-6;
  fcl::CollisionResultd result;
  return fcl::collide(a, X_A, b, X_B, request, result) > 0;
}

fcl::Transform3d pose(const OrientedBox& box) {
  fcl::Transform3d X = fcl::Transform3d::Identity();
  X.linear() = box.R_CB;
  X.translation() = box.p_CB;
  return X;
}

template <class Visitor>
bool any_box(const SweptHand& hand, bool with_closing, Visitor&& visit) {
  if (visit(hand.fingers[0]) || visit(hand.fingers[1]) || visit(hand.palm)) return true;
  return with_closing && (visit(hand.closing[0]) || visit(hand.closing[1]));
}

bool crosses(const SweptHand& hand, const SupportPlane& plane, double margin) {
  return any_box(hand, true, [&](const OrientedBox& box) {
    return -box.support(-plane.n_C) < plane.d + margin;
  });
}

bool hits(const SweptHand& hand, const std::vector<CollisionShape>& shapes, double margin,
          bool with_closing) {
  return any_box(hand, with_closing, [&](const OrientedBox& box) {
    const OrientedBox grown = box.inflated(margin);
    return std::any_of(shapes.begin(), shapes.end(),
                       [&](const CollisionShape& shape) { return overlaps(grown, shape); });
  });
}

std::optional<Obstruction> voxel_hit(const SweptHand& hand, const ObstacleMap& map, double margin) {
  Hit hit = Hit::kNone;
  any_box(hand, true, [&](const OrientedBox& box) {
    hit = map.collides(margin > 0.0 ? box.inflated(margin) : box);
    return hit != Hit::kNone;
  });
  if (hit == Hit::kNone) return std::nullopt;
  return hit == Hit::kOccupied ? Obstruction::kOccupied : Obstruction::kUnknown;
}

}  // namespace

bool overlaps(const OrientedBox& box, const CollisionShape& shape) {
  if (!shape.geometry) return false;
  const double reach = shape.geometry->aabb_radius + box.half.norm();
  const Eigen::Vector3d centre = shape.X_CS * shape.geometry->aabb_center;
  if ((centre - box.p_CB).squaredNorm() > reach * reach) return false;
  const fcl::Boxd geometry(2.0 * box.half);
  fcl::Transform3d X = fcl::Transform3d::Identity();
  X.matrix() = shape.X_CS.matrix();
  return fcl_collide(&geometry, pose(box), shape.geometry.get(), X);
}

bool overlaps(const OrientedBox& box, const std::shared_ptr<const octomap::OcTree>& tree) {
  if (!tree || !tree->getRoot()) return false;
  fcl::OcTreed geometry(tree);
  geometry.computeLocalAABB();
  const fcl::Boxd solid(2.0 * box.half);
  return fcl_collide(&geometry, fcl::Transform3d::Identity(), &solid, pose(box));
}

std::optional<Obstruction> CollisionScene::obstruction(const SweptHand& hand) const {
  for (const SupportPlane& plane : planes) {
    if (crosses(hand, plane, margin)) return Obstruction::kSupport;
  }
  if (const auto hit = voxel_hit(hand, map, 0.0)) return hit;
  if (hits(hand, target, margin, false)) return Obstruction::kTarget;
  if (hits(hand, neighbours, margin, true)) return Obstruction::kNeighbour;
  return std::nullopt;
}

double CollisionScene::clearance(const SweptHand& hand) const {
  const auto blocked = [&](double r) {
    for (const SupportPlane& plane : planes) {
      if (crosses(hand, plane, r)) return true;
    }
    return voxel_hit(hand, map, r).has_value() || hits(hand, neighbours, r, true);
  };
  double free = 0.0, hit = 0.032;
  if (!blocked(hit)) return hit;
  for (int step = 0; step < 5; ++step) {
    const double middle = 0.5 * (free + hit);
    (blocked(middle) ? hit : free) = middle;
  }
  return free;
}

}  // namespace quadrille
