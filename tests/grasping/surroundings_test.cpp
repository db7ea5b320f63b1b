// Surroundings move with the frame, and those that make no sense are refused.
#include "quadrille/grasping/surroundings.hpp"

#include <octomap/OcTree.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "grasping/known_scene.hpp"
#include "grasping/scenes.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/rigid_motion.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"
#include "support/error_of.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("surroundings come back when they are moved there and back", "[surroundings][frames]") {
  std::mt19937 random(12);
  CanScene scene;
  scene.with_finger = true;
  Surroundings known;
  known.views = {scene.cloud()};
  known.robot = scene.finger();
  known.support = KnownSupport{Eigen::Vector3d(0.6, 0.0, 0.8), 0.3};
  known.map = {std::make_shared<octomap::OcTree>(0.01), turned_frame()};
  const Eigen::Isometry3d X_FC = random_pose(random);
  const Surroundings there = moved(known, X_FC);
  // A point on the plane stays on it.
  const Eigen::Vector3d on_plane(0.5, 0.7, 0.0);
  REQUIRE(known.support->n_C.dot(on_plane) == Approx(known.support->offset));
  CHECK(there.support->n_C.dot(X_FC * on_plane) == Approx(there.support->offset));
  CHECK((there.support->n_C - X_FC.linear() * known.support->n_C).norm() < 1e-12);
  CHECK(there.views[0].viewpoint.isApprox(X_FC.translation()));
  CHECK(there.map.tree == known.map.tree);
  CHECK((there.map.X_CM.matrix() - (X_FC * known.map.X_CM).matrix()).norm() < 1e-12);
  const Surroundings back = moved(there, X_FC.inverse());
  CHECK((back.support->n_C - known.support->n_C).norm() < 1e-12);
  CHECK(back.support->offset == Approx(known.support->offset));
  CHECK((back.robot.shapes[0].X_CS.matrix() - known.robot.shapes[0].X_CS.matrix()).norm() < 1e-12);
  CHECK((back.map.X_CM.matrix() - known.map.X_CM.matrix()).norm() < 1e-12);
  for (std::size_t k = 0; k < known.views[0].points.size(); k += 97) {
    const Eigen::Vector3f p = known.views[0].points[k];
    if (p.allFinite()) CHECK((back.views[0].points[k] - p).norm() < 1e-6f);
  }
  CHECK(error_of([&] { back.check(); }).empty());
}

TEST_CASE("plans with all that is known turn with the frame", "[surroundings][frames]") {
  CanScene scene;
  scene.with_finger = true;
  Surroundings known;
  known.robot = scene.finger();
  KnownSupport support;
  support.n_C = scene.X_CW.linear().col(2);
  support.offset = support.n_C.dot(scene.X_CW.translation());
  known.support = support;
  const Eigen::Isometry3d X_BC = (scene.X_CW * translation(0.12, 0.0, 0.08)).inverse();
  known.map =
      map_with(turned_frame(), 0.005, around_can(scene, 0.25), [&](const Eigen::Vector3d& p_C) {
        return in_block(X_BC, {0.06, 0.1, 0.08}, 0.0, p_C) ? 1 : -1;
      });
  const GraspPlan here = plan_scene(scene, known);
  REQUIRE_FALSE(here.grasps.empty());
  Eigen::Isometry3d X_FC = Eigen::Isometry3d::Identity();
  X_FC.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  X_FC.translation() = Eigen::Vector3d(0.25, -0.5, 1.0);
  std::vector<Detection> detections = scene.detections();
  for (Detection& d : detections) d = moved(d, X_FC);
  const GraspPlan there = plan_grasps(moved(scene.cloud(), X_FC), detections, franka_hand(),
                                      policy_of(UnknownPolicy::kFree), moved(known, X_FC));
  REQUIRE_FALSE(there.grasps.empty());
  CHECK(there.grasps.front().score == Approx(here.grasps.front().score).epsilon(0.1));
  const double share =
      static_cast<double>(there.grasps.size()) / static_cast<double>(here.grasps.size());
  CHECK(share > 0.6);
  CHECK(share < 1.6);
  // The block is where it was.
  for (const Grasp& grasp : there.grasps) {
    const Grasp back = moved(grasp, X_FC.inverse());
    CHECK_FALSE(any_place_in(boxes_of(back), [&](const Eigen::Vector3d& p_C) {
      return in_block(X_BC, {0.06, 0.1, 0.08}, -0.009, p_C);
    }));
    CHECK(lowest_corner(back, scene) > -0.001);
  }
}

TEST_CASE("surroundings that make no sense are refused", "[surroundings][hostile]") {
  const CanScene scene;
  Surroundings known;
  CHECK(error_of([&] { known.check(); }).empty());
  for (const Eigen::Vector3d& n : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, 1.1),
                                   Eigen::Vector3d(0, 0, std::nan(""))}) {
    known.support = KnownSupport{n, 0.0};
    CHECK(error_of([&] { known.check(); }).find("support") != std::string::npos);
    CHECK_THROWS_AS(plan_scene(scene, known), std::invalid_argument);
  }
  known.support = KnownSupport{Eigen::Vector3d::UnitZ(), HUGE_VAL};
  CHECK(error_of([&] { known.check(); }).find("support") != std::string::npos);
  known.support.reset();
  known.robot = scene.finger();
  known.robot.padding = -1.0;
  CHECK(error_of([&] { known.check(); }).find("padding") != std::string::npos);
  known.robot = scene.finger();
  known.robot.shapes[0].dimensions.pop_back();
  CHECK(error_of([&] { known.check(); }).find("dimensions") != std::string::npos);
  CHECK_THROWS_AS(plan_scene(scene, known), std::invalid_argument);
}

TEST_CASE("a map at a pose that is none is refused", "[surroundings][hostile]") {
  Surroundings known;
  known.map.tree = std::make_shared<octomap::OcTree>(0.01);
  known.map.X_CM.translation().x() = std::nan("");
  CHECK(error_of([&] { known.check(); }).find("map") != std::string::npos);
}
