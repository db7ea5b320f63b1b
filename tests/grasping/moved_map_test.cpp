// The map of a plan in another frame is not thicker than in that of the plan.
#include <octomap/OcTree.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <set>
#include <vector>

#include "grasping/known_scene.hpp"
#include "grasping/plans.hpp"
#include "grasping/scenes.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/solid_shape.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/surroundings.hpp"
#include "space/voxel_key.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("the occupied voxels of a moved map are those that hold a point", "[frames][occupancy]") {
  std::mt19937 random(8);
  const std::vector<Ball> balls = {ball_on_table(0.0, 0.0, 0.03), ball_on_table(0.2, 0.0, 0.04)};
  const PointCloud cloud = render(balls);
  const OccupancyGrid here = *plan_balls(balls).space;
  for (int pose = 0; pose < 5; ++pose) {
    const Eigen::Isometry3d X_FC = random_pose(random);
    const OccupancyGrid there = here.moved(X_FC);
    std::set<VoxelKey> holding;
    int points = 0, lost = 0;
    for (const Eigen::Vector3f& point_C : cloud.points) {
      const Eigen::Vector3d p_C = point_C.cast<double>();
      if (here.at(p_C) != Voxel::kOccupied) continue;
      const Eigen::Vector3d p_F = X_FC * p_C;
      ++points;
      // Points that are rounded to the other side of a voxel's face are not lost.
      lost += there.at(p_F) != Voxel::kOccupied;
      holding.insert(voxel_key(p_F, there.resolution()));
    }
    const auto occupied =
        std::count(there.states().begin(), there.states().end(), Voxel::kOccupied);
    CAPTURE(points, lost, holding.size(), occupied);
    CHECK(points > 2000);
    CHECK(lost < 5);
    CHECK(std::abs(static_cast<double>(occupied) - static_cast<double>(holding.size())) < 5.0);
  }
}

TEST_CASE("a map of a map has the other map's voxels in its frame, and none on the robot",
          "[frames][occupancy][map]") {
  std::mt19937 random(9);
  const std::vector<Ball> balls = {ball_on_table(0.0, 0.0, 0.03)};
  const Eigen::Isometry3d X_FC = random_pose(random);
  // Two things that the cloud does not show, of which the robot fills one.
  const Eigen::Vector3d one_C = balls.front().p_C + Eigen::Vector3d(0.0, -0.1, 0.0);
  const Eigen::Vector3d two_C = balls.front().p_C + Eigen::Vector3d(0.08, -0.08, 0.0);
  auto tree = std::make_shared<octomap::OcTree>(PlanOptions{}.resolution);
  for (const Eigen::Vector3d& p_C : {one_C, two_C}) tree->updateNode(octo_point(X_FC * p_C), true);
  Surroundings known;
  known.map = {tree, X_FC.inverse()};
  SolidShape arm;
  arm.kind = "sphere";
  arm.dimensions = {0.02};
  arm.X_CS.translation() = two_C;
  known.robot = {{arm}, 0.01};
  const OccupancyGrid there =
      GraspScene(render(balls), detections_of(balls), franka_hand(), {}, known)
          .plan({})
          .space->moved(X_FC);
  const auto as_in_tree = [&](const Eigen::Vector3d& p_C) {
    const octomap::point3d m = tree->keyToCoord(tree->coordToKey(octo_point(X_FC * p_C)));
    return there.at({m.x(), m.y(), m.z()});
  };
  CHECK(as_in_tree(one_C) == Voxel::kOccupied);
  CHECK(as_in_tree(two_C) != Voxel::kOccupied);
  int near = 0;
  for (int k = 0; k < there.size().z(); ++k) {
    for (int j = 0; j < there.size().y(); ++j) {
      for (int i = 0; i < there.size().x(); ++i) {
        const bool close = (there.centre(i, j, k) - X_FC * one_C).norm() < 0.03;
        near += close && there.at(i, j, k) == Voxel::kOccupied;
      }
    }
  }
  CHECK(near == 1);
}
