#include <cstddef>
#include <nlohmann/json.hpp>
#include <variant>

#include "io/cloud_file.hpp"
#include "io/json/json_parts.hpp"
#include "process/planner/messages.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/plan.hpp"
#include "support/catch.hpp"
#include "support/scans.hpp"

namespace quadrille {
namespace {

/// The pose that a reader gets who has written JSON as text.
Eigen::Matrix4d read_back(const Eigen::Isometry3d& X) {
  return io::pose_of(io::Json::parse(io::to_json(X).dump())).matrix();
}

TEST_CASE("receivers of messages and readers of JSON have the detector's bits", "[determinism]") {
  for (const char* name : {"mug.pcd", "boxes.pcd"}) {
    bus::CloudMessage cloud;
    cloud.cloud = io::read_cloud((test::scans_folder() / name).string());
    const DetectionResult found = detect(cloud.cloud);
    REQUIRE_FALSE(found.detections.empty());
    REQUIRE_FALSE(found.bodies.empty());
    const auto quadrics = std::get<bus::QuadricsMessage>(
        bus::decode_quadrics(bus::encode(bus::to_message(cloud, found))));
    for (std::size_t n = 0; n < found.detections.size(); ++n) {
      const Detection &sent = found.detections[n], &got = quadrics.detections[n];
      CHECK(got.X_CQ.matrix() == sent.X_CQ.matrix());
      CHECK(got.Q_C.matrix() == sent.Q_C.matrix());
      CHECK(got.score == sent.score);
      CHECK(got.rms == sent.rms);
      CHECK(got.dimension(0) == sent.dimension(0));
      CHECK(got.extent_Q.isApprox(sent.extent_Q, 0.0));
      CHECK(read_back(sent.X_CQ) == sent.X_CQ.matrix());
    }
    const auto boxes = std::get<bus::BoxesMessage>(
        bus::decode_boxes(bus::encode(bus::to_message(cloud, found.boxes))));
    for (std::size_t n = 0; n < found.boxes.size(); ++n) {
      CHECK(boxes.boxes[n].X_CB.matrix() == found.boxes[n].X_CB.matrix());
      CHECK(read_back(found.boxes[n].X_CB) == found.boxes[n].X_CB.matrix());
    }
    const auto bodies = std::get<bus::BodiesMessage>(
        bus::decode_bodies(bus::encode(bus::to_message(cloud, found.bodies))));
    for (std::size_t n = 0; n < found.bodies.size(); ++n) {
      CHECK(bodies.bodies[n].X_CB.matrix() == found.bodies[n].X_CB.matrix());
      CHECK(read_back(found.bodies[n].X_CB) == found.bodies[n].X_CB.matrix());
    }
  }
}

TEST_CASE("receivers of messages and readers of JSON have the planner's bits", "[determinism]") {
  const PointCloud cloud = io::read_cloud((test::scans_folder() / "mug.pcd").string());
  const DetectionResult found = detect(cloud);
  const GraspPlan plan =
      plan_grasps(cloud, found.detections, franka_hand(), {}, {}, {}, found.boxes, found.bodies);
  REQUIRE_FALSE(plan.grasps.empty());
  for (const Grasp& grasp : plan.grasps) {
    CHECK(bus::from_message(to_message(grasp).pose).matrix() == grasp.X_CG.matrix());
    CHECK(read_back(grasp.X_CG) == grasp.X_CG.matrix());
  }
  REQUIRE_FALSE(plan.shapes.empty());
  for (const CollisionShape& shape : plan.shapes) {
    CHECK(bus::from_message(to_message(shape).pose).matrix() == shape.X_CS.matrix());
  }
}

}  // namespace
}  // namespace quadrille
