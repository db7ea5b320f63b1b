#include <octomap/OcTree.h>

#include <map>
#include <sstream>

#include "grasping/scenes.hpp"
#include "process/planner/messages.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/grasping/plan.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

Stamp make_stamp() { return {77, 5, "camera"}; }

/// Encodes and decodes a message, as the bus does.
template <class Message>
Message send(const Message& message) {
  const auto bytes = bus::encode(message);
  Message got;
  const int size = static_cast<int>(bytes.size());
  REQUIRE(got.decode(bytes.data(), 0, size) == size);
  CHECK(got.utime == 77);
  CHECK(got.seq == 5);
  CHECK(got.frame == "camera");
  return got;
}

TEST_CASE("grasps keep all their fields in the message", "[planner][messages]") {
  Grasp grasp;
  grasp.target = 3;
  grasp.score = 0.75;
  grasp.X_CG = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX());
  grasp.width = 0.04;
  grasp.preshape = 0.06;
  grasp.contacts_C = {Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(4, 5, 6)};
  grasp.approach = 0.1;
  grasp.friction_needed = 0.2;
  grasp.epsilon = 0.3;
  grasp.clearance = 0.01;
  grasp.unknown_contact = true;
  GraspPlan plan;
  plan.grasps = {grasp};
  plan.rejected = {{"collision", 7}, {"width", 2}};
  plan.targets = {{4, 0, {{Refusal::kWidth, 2}, {Refusal::kCollision, 7}}}, {6, 1, {}}};
  plan.remedies = {{4, "--gripper wsg50", 3, 0.625}};
  plan.looks = {{grasp.X_CG, {4, 6}, 1.5}};
  plan.warnings = {"no table"};
  PlannerSettings settings;
  settings.gripper.name = "franka";
  settings.plan.unknown = UnknownPolicy::kTargetShadow;
  const grasps_t got = send(make_grasps_message(make_stamp(), plan, settings));
  CHECK(got.gripper == "franka");
  CHECK(got.unknown == "target-shadow");
  CHECK(got.warnings == plan.warnings);
  REQUIRE(got.rejected.size() == 2);
  CHECK(got.rejected[0].name == "collision");
  CHECK(got.rejected[0].count == 7);
  REQUIRE(got.targets.size() == 2);
  CHECK(got.targets[0].target == 4);
  CHECK(got.targets[0].num_grasps == 0);
  CHECK(got.targets[0].furthest == "collision");
  CHECK(got.targets[0].rejected.size() == 2);
  CHECK(got.targets[1].num_grasps == 1);
  CHECK(got.targets[1].furthest.empty());
  REQUIRE(got.remedies.size() == 1);
  CHECK(got.remedies[0].target == 4);
  CHECK(got.remedies[0].change == "--gripper wsg50");
  CHECK(got.remedies[0].num_grasps == 3);
  CHECK(got.remedies[0].score == 0.625);
  REQUIRE(got.looks.size() == 1);
  CHECK(bus::from_message(got.looks[0].pose).isApprox(grasp.X_CG, 1e-12));
  CHECK(got.looks[0].bodies == std::vector<std::int32_t>{4, 6});
  CHECK(got.looks[0].gain == 1.5);
  REQUIRE(got.grasps.size() == 1);
  const grasp_t& m = got.grasps[0];
  CHECK(m.target == 3);
  CHECK(m.score == 0.75);
  CHECK(bus::from_message(m.pose).isApprox(grasp.X_CG, 1e-12));
  CHECK(m.width == 0.04);
  CHECK(m.preshape == 0.06);
  CHECK(m.contacts[0][1] == 2.0);
  CHECK(m.contacts[1][2] == 6.0);
  CHECK(m.approach == 0.1);
  CHECK(m.friction_needed == 0.2);
  CHECK(m.epsilon == 0.3);
  CHECK(m.clearance == 0.01);
  CHECK(m.unknown_contact != 0);
}

TEST_CASE("collision shapes keep their sizes, vertices and faces", "[planner][messages]") {
  CollisionShape shape;
  shape.target = 4;
  shape.kind = "convex";
  shape.dimensions = {0.1, 0.2};
  shape.vertices_S = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  shape.faces = {3, 0, 1, 2};
  GraspPlan plan;
  plan.shapes = {shape};
  const collision_shapes_t got = send(make_shapes_message(make_stamp(), plan));
  REQUIRE(got.shapes.size() == 1);
  CHECK(got.shapes[0].target == 4);
  CHECK(got.shapes[0].kind == "convex");
  CHECK(got.shapes[0].dimensions == shape.dimensions);
  CHECK(got.shapes[0].vertices[2] == std::vector<double>{7, 8, 9});
  CHECK(got.shapes[0].faces == std::vector<std::int32_t>{3, 0, 1, 2});
}

TEST_CASE("OctoMap reads the occupancy back: free, occupied and unknown", "[planner][messages]") {
  const test::Ball ball = test::ball_on_table(0.0, 0.0, 0.03);
  PlanOptions options;
  options.clear_above = false;
  const GraspPlan plan =
      plan_grasps(test::render({ball}), {test::sphere_detection(ball)}, franka_hand(), options);
  const OccupancyGrid& space = *plan.space;
  const occupancy_t got = send(make_occupancy_message(make_stamp(), &space));
  CHECK(got.resolution == space.resolution());
  std::istringstream stream(std::string(got.data.begin(), got.data.end()));
  octomap::OcTree tree(1.0);
  REQUIRE(tree.readBinary(stream));
  CHECK(tree.getResolution() == space.resolution());
  int occupied = 0, leaves = 0;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf, ++leaves) {
    occupied += tree.isNodeOccupied(*leaf);
  }
  CHECK(got.num_occupied == occupied);
  CHECK(got.num_free == leaves - occupied);
  std::map<Voxel, int> compared;
  int wrong = 0;
  for (int k = 0; k < space.size().z(); ++k) {
    for (int j = 0; j < space.size().y(); ++j) {
      for (int i = 0; i < space.size().x(); ++i) {
        const Eigen::Vector3d p_C = space.centre(i, j, k);
        const auto* node = tree.search(p_C.x(), p_C.y(), p_C.z());
        const Voxel read = !node                       ? Voxel::kUnknown
                           : tree.isNodeOccupied(node) ? Voxel::kOccupied
                                                       : Voxel::kFree;
        wrong += read != space.at(i, j, k);
        ++compared[read];
      }
    }
  }
  CHECK(wrong == 0);
  CHECK(compared.size() == 3);
  CHECK(tree.search(9.0, 9.0, 9.0) == nullptr);
}

TEST_CASE("a plan without a map gives a message without data", "[planner][messages]") {
  const occupancy_t got = send(make_occupancy_message(make_stamp(), nullptr));
  CHECK(got.data.empty());
  CHECK(got.num_free == 0);
}

}  // namespace
}  // namespace quadrille
