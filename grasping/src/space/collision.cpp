#include "space/collision.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <array>
#include <span>

namespace quadrille {
namespace {

/// Only FCL's collide() is used: distance() and continuousCollide() fail on half-spaces and empty
/// octrees, or miss thin walls between their samples. The solver is libccd's, because FCL's own
/// (GST_INDEP) lets a small box inside a Convex pass.
bool fcl_collide(const fcl::CollisionGeometryd* a, const fcl::Transform3d& X_A,
                 const fcl::CollisionGeometryd* b, const fcl::Transform3d& X_B) {
  fcl::CollisionRequestd request(1, false);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.gjk_tolerance = 1e-6;
  fcl::CollisionResultd result;
  return fcl::collide(a, X_A, b, X_B, request, result) > 0;
}

// libccd iterates to a tolerance and misses overlaps shallower than that. In a million random and
// touching queries, the deepest overlap that it missed was between 0.1 and 1 µm [m].
constexpr double kSolverSlack = 2e-6;

/// Returns true if a face of the box, or of the bounding box of the shape, separates them.
bool apart(const OrientedBox& box, const CollisionShape& shape) {
  const auto& bounds = shape.geometry->aabb_local;
  const Eigen::Vector3d half_S = (0.5 * (bounds.max_ - bounds.min_)).array() + kSolverSlack;
  const Eigen::Matrix3d R_SC = shape.X_CS.linear().transpose();
  const Eigen::Vector3d t_S = R_SC * (box.p_CB - shape.X_CS * shape.geometry->aabb_center);
  const double reach = shape.geometry->aabb_radius + kSolverSlack + box.half.norm();
  if (t_S.squaredNorm() > reach * reach) return true;
  const Eigen::Matrix3d R_SB = R_SC * box.R_CB, turned = R_SB.cwiseAbs();
  return (t_S.cwiseAbs().array() > (half_S + turned * box.half).array()).any() ||
         ((R_SB.transpose() * t_S).cwiseAbs().array() >
          (box.half + turned.transpose() * half_S).array())
             .any();
}

fcl::Transform3d pose(const OrientedBox& box) {
  fcl::Transform3d X = fcl::Transform3d::Identity();
  X.linear() = box.R_CB;
  X.translation() = box.p_CB;
  return X;
}

bool crosses(std::span<const OrientedBox> boxes, const SupportPlane& plane, double margin) {
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const OrientedBox& box) { return plane.meets(box, margin); });
}

bool hits(std::span<const OrientedBox> boxes, const std::vector<CollisionShape>& shapes,
          double margin) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const OrientedBox& box) {
    const OrientedBox grown = box.inflated(margin);
    return std::any_of(shapes.begin(), shapes.end(),
                       [&](const CollisionShape& shape) { return overlaps(grown, shape); });
  });
}

Hit voxel_hit(std::span<const OrientedBox> boxes, const CollisionScene& scene, double margin) {
  for (const OrientedBox& box : boxes) {
    const OrientedBox grown = margin > 0.0 ? box.inflated(margin) : box;
    const Hit hit = scene.map.collides(grown);
    if (hit != Hit::kNone) return hit;
    if (scene.known_map && scene.known_map->meets(grown)) return Hit::kOccupied;
  }
  return Hit::kNone;
}

// The closing fingers touch the outermost points, so points this near to their surface are no
// obstacles to them, whatever the rounding [m].
constexpr double kTouch = 0.0003;

bool touch(std::span<const OrientedBox> boxes, const ObstaclePoints& points, double margin) {
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const OrientedBox& box) { return points.meet(box.inflated(margin)); });
}

// A point belongs to a plane up to this many root mean squares of the plane's points above it: of
// normal noise, one point in 700 lies higher.
constexpr double kFlatSigmas = 3.0;
// Even without noise nothing lower is told from a plane: tables are no flatter than this [m].
constexpr double kLeastFlatness = 0.002;
// However noisy a plane is, points that are higher count as things, as they do where the points of
// targets are told from those of supports (target_surfaces.cpp) [m].
constexpr double kMostFlatness = 0.006;

/// Returns what `solid` or `closing` runs into first. `solid` must keep off everything, and keep a
/// distance of `off_target` from the target, which `closing` may touch.
std::optional<Obstruction> first_obstruction(const CollisionScene& scene,
                                             std::span<const OrientedBox> solid,
                                             std::span<const OrientedBox> closing,
                                             double off_target) {
  for (const SupportPlane& plane : scene.planes) {
    const double off = std::max(scene.margin, plane.flatness());
    if (crosses(solid, plane, off) || crosses(closing, plane, off)) {
      return Obstruction::kSupport;
    }
  }
  for (const auto boxes : {solid, closing}) {
    const Hit hit = voxel_hit(boxes, scene, 0.0);
    if (hit == Hit::kOccupied) return Obstruction::kOccupied;
    if (hit == Hit::kUnknown) return Obstruction::kUnknown;
  }
  if (touch(solid, scene.points, scene.margin) || touch(closing, scene.points, -kTouch)) {
    return Obstruction::kOccupied;
  }
  if (hits(solid, scene.target, off_target)) return Obstruction::kTarget;
  if (hits(solid, scene.neighbours, scene.margin)) return Obstruction::kNeighbour;
  if (hits(closing, scene.neighbours, scene.margin)) return Obstruction::kNeighbour;
  return std::nullopt;
}

}  // namespace

double SupportPlane::flatness() const {
  return gave_way ? std::clamp(kFlatSigmas * rms, kLeastFlatness, kMostFlatness) : kLeastFlatness;
}

bool SupportPlane::meets(const OrientedBox& box, double margin) const {
  const Eigen::Matrix3d R_PC = X_CP.linear().transpose();
  const Eigen::Vector3d centre = R_PC * (box.p_CB - X_CP.translation());
  const Eigen::Vector3d reach = (R_PC * box.R_CB).cwiseAbs() * box.half;
  if (centre.z() - reach.z() >= margin) return false;
  const Eigen::Vector2d low = (centre - reach).head<2>(), high = (centre + reach).head<2>();
  return extent_P.intersects(Eigen::AlignedBox2d(low, high));
}

bool may_reach(const CollisionShape& shape, const Eigen::AlignedBox3d& region_C) {
  return shape.geometry &&
         !apart({Eigen::Matrix3d::Identity(), region_C.center(), 0.5 * region_C.sizes()}, shape);
}

bool overlaps(const OrientedBox& box, const CollisionShape& shape) {
  if (!shape.geometry || apart(box, shape)) return false;
  const fcl::Boxd geometry(2.0 * (box.half.array() + kSolverSlack));
  fcl::Transform3d X = fcl::Transform3d::Identity();
  X.matrix() = shape.X_CS.matrix();
  return fcl_collide(&geometry, pose(box), shape.geometry.get(), X);
}

std::optional<Obstruction> CollisionScene::palm_obstruction(const OrientedBox& palm) const {
  return first_obstruction(*this, {&palm, 1}, {}, end_doubt);
}

std::optional<Obstruction> CollisionScene::back_obstruction(const SweptHand& hand) const {
  if (const auto what = palm_obstruction(hand.palm)) return what;
  return first_obstruction(*this, hand.attached, {}, end_doubt);
}

std::optional<Obstruction> CollisionScene::finger_obstruction(const SweptHand& hand) const {
  return first_obstruction(*this, hand.fingers, hand.closing, margin);
}

std::optional<Obstruction> CollisionScene::closing_obstruction(
    const std::array<OrientedBox, 2>& fingers) const {
  return first_obstruction(*this, {}, fingers, margin);
}

double CollisionScene::clearance(const SweptHand& hand) const {
  std::vector<OrientedBox> boxes = hand.attached;
  boxes.insert(boxes.end(),
               {hand.fingers[0], hand.fingers[1], hand.palm, hand.closing[0], hand.closing[1]});
  enum class Kind { kPlane, kVoxel, kPoint, kNeighbour };
  struct Check {
    Kind kind;
    std::span<const OrientedBox> box;
  };
  std::vector<Check> checks;
  for (const Kind kind : {Kind::kPlane, Kind::kVoxel, Kind::kPoint, Kind::kNeighbour}) {
    for (const OrientedBox& box : boxes) checks.push_back({kind, {&box, 1}});
  }
  const auto meets = [&](const Check& check, double r) {
    switch (check.kind) {
      case Kind::kPlane:
        return std::any_of(planes.begin(), planes.end(),
                           [&](const SupportPlane& plane) { return crosses(check.box, plane, r); });
      case Kind::kVoxel:
        return voxel_hit(check.box, *this, r) != Hit::kNone;
      case Kind::kPoint:
        return touch(check.box, other_points, r);
      default:
        return hits(check.box, neighbours, r);
    }
  };
  // Once something is met at a radius, only smaller ones are tried, at which the checks before it
  // would meet nothing either.
  const auto blocked = [&](double r) {
    const auto first = std::find_if(checks.begin(), checks.end(),
                                    [&](const Check& check) { return meets(check, r); });
    if (first == checks.end()) return false;
    checks.erase(checks.begin(), first);
    return true;
  };
  double free = 0.0, hit = kMaxClearance;
  if (!blocked(hit)) return hit;
  for (int step = 0; step < 5; ++step) {
    const double middle = 0.5 * (free + hit);
    (blocked(middle) ? hit : free) = middle;
  }
  return free;
}

}  // namespace quadrille
