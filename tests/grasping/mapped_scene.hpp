#pragma once

#include <utility>

#include "grasping/scenes.hpp"
#include "space/space_mapper.hpp"

namespace quadrille::test {

constexpr double kResolution = 0.005;
inline const Eigen::AlignedBox3d kRegion(Eigen::Vector3d(-0.15, -0.15, 0.65),
                                         Eigen::Vector3d(0.15, 0.15, 0.95));

/// The map of a single view.
inline OccupancyGrid map_of(const PointCloud& cloud, const DepthView& view,
                            const Eigen::AlignedBox3d& region = kRegion,
                            double resolution = kResolution) {
  SpaceMapper mapper(region, resolution);
  mapper.add(cloud, view);
  return std::move(mapper).take();
}

/// Two balls on the table, rendered and mapped.
struct Scene {
  std::vector<Ball> balls = {ball_on_table(0.0, 0.0, 0.03), ball_on_table(0.09, 0.02, 0.025)};
  PointCloud cloud = render(balls);
  DepthView view{cloud};
  OccupancyGrid grid = map_of(cloud, view);
};

}  // namespace quadrille::test
