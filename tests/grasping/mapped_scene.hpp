#pragma once

#include "grasping/scenes.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "view/depth_view.hpp"

namespace quadrille::test {

constexpr double kResolution = 0.005;
inline const Eigen::AlignedBox3d kRegion(Eigen::Vector3d(-0.15, -0.15, 0.65),
                                         Eigen::Vector3d(0.15, 0.15, 0.95));

/// Two balls on the table, rendered and mapped.
struct Scene {
  std::vector<Ball> balls = {ball_on_table(0.0, 0.0, 0.03), ball_on_table(0.09, 0.02, 0.025)};
  PointCloud cloud = render(balls);
  DepthView view{cloud};
  OccupancyGrid grid{cloud, view, kRegion, kResolution};
};

}  // namespace quadrille::test
