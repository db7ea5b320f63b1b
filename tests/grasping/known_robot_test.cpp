// A known robot in the picture costs no grasp, is nothing to hold, and hides what is behind it.
#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "grasping/known_scene.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/surroundings.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("a robot's finger in the picture costs no grasp, if it is known",
          "[surroundings][robot]") {
  CanScene scene;
  const std::vector<Grasp> clean = all_hands(scene, {});
  scene.with_finger = true;
  Surroundings known;
  const std::vector<Grasp> obstructed = all_hands(scene, known);
  known.robot = scene.finger();
  const std::vector<Grasp> told = all_hands(scene, known);
  CAPTURE(clean.size(), obstructed.size(), told.size());
  REQUIRE(clean.size() > 50);
  CHECK(static_cast<double>(count_among(clean, obstructed)) <
        0.8 * static_cast<double>(clean.size()));
  CHECK(static_cast<double>(count_among(clean, told)) > 0.97 * static_cast<double>(clean.size()));
}

TEST_CASE("nothing is found or planned on the robot, if it is known", "[surroundings][robot]") {
  CanScene scene;
  scene.with_finger = true;
  const PointCloud cloud = scene.cloud();
  Surroundings known;
  const auto on_finger = [&](const GraspPlan& plan) {
    return std::count_if(plan.grasps.begin(), plan.grasps.end(), [&](const Grasp& grasp) {
      return std::any_of(grasp.contacts_C.begin(), grasp.contacts_C.end(), [&](const auto& p_C) {
        return in_block(scene.X_CFinger.inverse(), 0.5 * scene.finger_size, 0.005, p_C);
      });
    });
  };
  const auto planned = [&](const PointCloud& seen) {
    const DetectionResult found = detect(seen);
    return plan_grasps(cloud, found.detections, franka_hand(), policy_of(UnknownPolicy::kFree),
                       known, {}, found.boxes, found.bodies);
  };
  // The finger is something that could be held.
  CHECK(on_finger(planned(cloud)) > 0);
  known.robot = scene.finger();
  const GraspPlan told = planned(known.robot.taken_from(cloud));
  CHECK(on_finger(told) == 0);
  CHECK_FALSE(told.grasps.empty());
}

TEST_CASE("space behind the robot stays unknown, and its own space is free",
          "[surroundings][robot]") {
  CanScene scene;
  scene.with_finger = true;
  Surroundings known;
  known.robot = scene.finger();
  const GraspPlan plan = plan_scene(scene, known, UnknownPolicy::kObstacle);
  const GraspPlan untold = plan_scene(scene, {}, UnknownPolicy::kObstacle);
  REQUIRE(plan.space);
  REQUIRE(untold.space);
  int inside = 0, free = 0, behind = 0, unknown = 0, occupied = 0;
  for (double z = -0.05; z <= 0.05; z += 0.005) {
    const Eigen::Vector3d middle_C = scene.X_CFinger * Eigen::Vector3d(0.0, 0.0, z);
    if (!plan.space->bounds().contains(middle_C)) continue;
    ++inside;
    free += plan.space->at(middle_C) == Voxel::kFree;
    // The side towards the camera.
    for (double depth = -0.02; depth <= 0.02; depth += 0.001) {
      const Eigen::Vector3d p_C = middle_C + depth * middle_C.normalized();
      occupied += untold.space->at(p_C) == Voxel::kOccupied;
      CHECK(plan.space->at(p_C) != Voxel::kOccupied);
    }
    const Eigen::Vector3d behind_C = middle_C + 0.04 * middle_C.normalized();
    if (!plan.space->bounds().contains(behind_C) || height_in(scene, behind_C) < 0.02) continue;
    ++behind;
    unknown += plan.space->at(behind_C) == Voxel::kUnknown;
  }
  CHECK(inside > 10);
  CHECK(free == inside);
  CHECK(behind > 5);
  CHECK(unknown == behind);
  CHECK(occupied > 10);
}
