#include "targets/target_scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "body/pieces.hpp"
#include "space/voxel_key.hpp"

namespace quadrille {
namespace {

// The target's points are carved up to this many of their standard deviations from its fitted
// surface: at least the first distance, since fits are no more accurate, at most the second [m].
constexpr double kCarveSigmas = 3.0, kMinCarveNoise = 0.002, kMaxCarveNoise = 0.01;
// If there are several views, each is a little off, so that the points of a target lie up to this
// far from its surface [m].
constexpr double kMinViewNoise = 0.005;
// A detection is part of the target if its centre lies in the target's body grown by the first
// value [m], and it is no larger than the body, to within a share of the body's size and a fixed
// error [m].
constexpr double kPartNoise = 0.006, kMaxPartShare = 1.3, kPartSizeError = 0.01;

/// Returns true for a cap, a second fit or a fragment of the target.
bool part_of(const ShapeOwner& other, const Body& body) {
  const double size = body.bounds_Q().sizes().maxCoeff();
  return body.contains(other.middle_C, kPartNoise) &&
         other.size <= kMaxPartShare * size + kPartSizeError;
}

CollisionScene uncarved_scene(const Target& target, const SceneParts& parts) {
  const Eigen::AlignedBox3d region = around(target.body, parts.reach + kMaxClearance);
  CollisionScene scene{parts.map->within(region), target.supports, {}, {}, {}};
  if (parts.known_map) scene.known_map = parts.known_map->within(region);
  for (std::size_t n = 0; n < parts.shapes.size(); ++n) {
    const ShapeOwner& owner = parts.owners[n];
    const CollisionShape& shape = parts.shapes[n];
    if (owner.id != target.id && !part_of(owner, target.body) && may_reach(shape, region)) {
      scene.neighbours.push_back(shape);
    }
  }
  return scene;
}

/// Returns how far from the target's surface a point may lie and still be explained by it [m].
double explained_distance(const Target& target, const SceneParts& parts) {
  const double own = std::clamp(kCarveSigmas * target.noise, kMinCarveNoise, kMaxCarveNoise);
  return parts.views.size() > 1 ? std::max(own, kMinViewNoise) : own;
}

/// Returns the margin by which the body is grown for carving. The centre of a voxel that reaches
/// into the target lies within half the voxel's diagonal, plus the noise of the points.
double carve_margin(const SceneParts& parts, const Target& target) {
  return 0.5 * std::sqrt(3.0) * parts.space->resolution() + explained_distance(target, parts);
}

/// The voxels about a body that hold more points outside of it than in it or on its surface.
class UnexplainedVoxels {
 public:
  UnexplainedVoxels(const Target& target, const SceneParts& parts)
      : edge_(parts.space->resolution()) {
    const double explained = explained_distance(target, parts);
    const Eigen::Isometry3d X_QC = target.body.X_CQ.inverse();
    const Eigen::AlignedBox3f near =
        around(target.body, carve_margin(parts, target) + edge_).cast<float>();
    // Points that follow each other mostly lie in the same voxel.
    VoxelKey last_key{};
    int* last = nullptr;
    parts.points.runs.each_in(near, [&](std::size_t n) {
      const Eigen::Vector3d p_C = parts.points.p_C[n].cast<double>();
      const VoxelKey key = voxel_key(p_C, edge_);
      if (last == nullptr || key != last_key) last = &outside_[key];
      last_key = key;
      *last += target.body.contains_Q(X_QC * p_C, explained) ? -1 : 1;
    });
  }

  bool contains(const Eigen::Vector3d& centre_C) const {
    const auto found = outside_.find(voxel_key(centre_C, edge_));
    return found != outside_.end() && found->second > 0;
  }

 private:
  double edge_;
  /// Number of points outside of the body, less that of the others.
  std::map<VoxelKey, int> outside_;
};

/// Returns true for voxels of the plane that the target stands on.
bool holds_up(const Target& target, const OccupancyGrid& space, const Eigen::Vector3d& p_C) {
  const auto near = [&](const SupportPlane& plane) {
    return plane.distance(p_C) < 0.5 * space.resolution();
  };
  return std::any_of(target.supports.begin(), target.supports.end(), near);
}

/// Lets the voxels of a map from elsewhere give way with those of the plan, and clears the shadow
/// of the target if that is wanted.
void end_carving(const Body& body, const SceneParts& parts, CollisionScene& scene) {
  if (scene.known_map) scene.known_map->follow(scene.map);
  if (parts.options.unknown != UnknownPolicy::kTargetShadow) return;
  scene.map.clear_shadow(body, around(body, parts.reach));
}

}  // namespace

CollisionScene solid_scene(const Target& target, const SceneParts& parts) {
  CollisionScene scene = uncarved_scene(target, parts);
  scene.target = make_pieces(target.body);
  const UnexplainedVoxels unexplained(target, parts);
  scene.map.carve(target.body, carve_margin(parts, target), [&](const Eigen::Vector3d& p_C) {
    return unexplained.contains(p_C) || holds_up(target, *parts.space, p_C);
  });
  end_carving(target.body, parts, scene);
  return scene;
}

CollisionScene point_scene(const Target& target, const TargetPoints& points,
                           const SceneParts& parts) {
  CollisionScene scene = uncarved_scene(target, parts);
  std::vector<Eigen::Vector3d> others;
  for (std::size_t i = 0; i < points.own.size(); ++i) {
    if (!points.own[i]) others.push_back(points.all.p_C[i]);
  }
  scene.points = ObstaclePoints(points.all.p_C);
  scene.other_points = ObstaclePoints(others);
  // Points show only the side towards the sensor; a shape tells of the other one.
  if (target.solid) scene.target = make_pieces(target.body);
  scene.map.carve(points.all.p_C, carve_margin(parts, target),
                  [&](const Eigen::Vector3d& p_C) { return holds_up(target, *parts.space, p_C); });
  end_carving(target.body, parts, scene);
  return scene;
}

CollisionScene shell_scene(const Target& target, const SceneParts& parts) {
  CollisionScene scene = uncarved_scene(target, parts);
  const Shell& shell = *target.shell;
  scene.target = make_wall(shell);
  scene.end_doubt = scene.margin;  // find_shell() put the rim where the points end
  const double margin = carve_margin(parts, target);
  scene.map.carve(shell.body, margin + shell.outer(), [&](const Eigen::Vector3d& p_C) {
    return !shell.in_wall(p_C, margin) || holds_up(target, *parts.space, p_C);
  });
  end_carving(shell.body, parts, scene);
  return scene;
}

}  // namespace quadrille
