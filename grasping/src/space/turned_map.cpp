#include "space/turned_map.hpp"

#include <octomap/OcTree.h>

#include <memory>
#include <utility>
#include <vector>

#include "space/evidence.hpp"
#include "space/map_limits.hpp"
#include "space/space_mapper.hpp"

namespace quadrille {
namespace {

bool is_turned(const KnownMap& map, const OccupancyGrid& plan) {
  return map.tree->getResolution() != plan.resolution() || !map.X_CM.matrix().isIdentity(0.0);
}

/// The region of a plan in the map's frame. A grid of whole blocks has to lie within the range of
/// voxels that are counted.
Eigen::AlignedBox3d region_in_map(const KnownMap& map, const OccupancyGrid& plan) {
  const double most =
      (OccupancyGrid::kMaxCoordinate - OccupancyGrid::kBlock) * map.tree->getResolution();
  const Eigen::AlignedBox3d countable_M(Eigen::Vector3d::Constant(-most),
                                        Eigen::Vector3d::Constant(most));
  return plan.bounds().transformed(map.X_CM.inverse()).intersection(countable_M);
}

}  // namespace

bool TurnedMap::is_too_fine(const KnownMap& map, const OccupancyGrid& plan) {
  if (!map.tree || plan.size().isZero() || !is_turned(map, plan)) return false;
  const Eigen::AlignedBox3d region_M = region_in_map(map, plan);
  return !region_M.isEmpty() &&
         count_voxels(region_M, map.tree->getResolution()) > OccupancyGrid::kMaxVoxels;
}

std::optional<TurnedMap> TurnedMap::of(const KnownMap& map, const OccupancyGrid& plan,
                                       const RobotShapes& robot_C) {
  if (!map.tree || plan.size().isZero() || !is_turned(map, plan)) return std::nullopt;
  const Eigen::AlignedBox3d region_M = region_in_map(map, plan);
  if (region_M.isEmpty() || is_too_fine(map, plan)) return std::nullopt;
  const Eigen::Isometry3d X_MC = map.X_CM.inverse();
  SpaceMapper mapper(region_M, map.tree->getResolution());
  mapper.add({map.tree, Eigen::Isometry3d::Identity()});
  const RobotShapes robot_M = quadrille::moved(robot_C, X_MC);
  for (const SolidShape& shape : robot_M.shapes) {
    mapper.free_within(NearShape(shape, robot_M.padding));
  }
  const OccupancyGrid grid = std::move(mapper).take_on_demand(
      std::make_shared<const std::vector<DepthView>>(), Eigen::Vector3d::Zero(), {});
  return TurnedMap(ObstacleMap(grid, false), X_MC);
}

TurnedMap TurnedMap::within(const Eigen::AlignedBox3d& region_C) const {
  return {voxels_M_.within(region_C.transformed(X_MC_)), X_MC_};
}

void TurnedMap::follow(const ObstacleMap& plan_C) {
  const Eigen::Isometry3d X_CM = X_MC_.inverse();
  voxels_M_.free_occupied(
      [&](const Eigen::Vector3d& middle_M) { return !plan_C.is_occupied(X_CM * middle_M); });
}

bool TurnedMap::meets(const OrientedBox& box_C) const {
  const OrientedBox box_M{X_MC_.linear() * box_C.R_CB, X_MC_ * box_C.p_CB, box_C.half};
  return voxels_M_.collides(box_M) == Hit::kOccupied;
}

}  // namespace quadrille
