#include "space/turned_map.hpp"

#include <octomap/OcTree.h>

#include <memory>
#include <utility>
#include <vector>

#include "space/evidence.hpp"
#include "space/map_limits.hpp"
#include "space/space_mapper.hpp"

namespace quadrille {

std::optional<TurnedMap> TurnedMap::of(const KnownMap& map, const OccupancyGrid& plan,
                                       const RobotShapes& robot_C) {
  if (!map.tree || plan.size().isZero()) return std::nullopt;
  const double edge = map.tree->getResolution();
  if (edge == plan.resolution() && map.X_CM.matrix().isIdentity(0.0)) return std::nullopt;
  const Eigen::Isometry3d X_MC = map.X_CM.inverse();
  // A grid of whole blocks has to lie within the range of voxels that are counted.
  const Eigen::Vector3d most =
      Eigen::Vector3d::Constant((OccupancyGrid::kMaxCoordinate - OccupancyGrid::kBlock) * edge);
  const Eigen::AlignedBox3d region_M =
      plan.bounds().transformed(X_MC).intersection(Eigen::AlignedBox3d(-most, most));
  if (region_M.isEmpty() || count_voxels(region_M, edge) > OccupancyGrid::kMaxVoxels) {
    return std::nullopt;
  }
  SpaceMapper mapper(region_M, edge);
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
