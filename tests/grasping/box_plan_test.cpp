// Grasps on boxes, from the planes of their faces to the hand.
#include <algorithm>
#include <set>

#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/shape.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

const Eigen::Vector3d kSize(0.06, 0.1, 0.07);

struct BoxScene {
  Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.5, 0.45});
  Eigen::Isometry3d X_CB = X_CW * test::translation(0, 0, 0.5 * kSize.z()) *
                           Eigen::Isometry3d(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()));
  PointCloud cloud;
  DetectionResult found;

  explicit BoxScene(const std::vector<test::Patch>& more = {}) {
    std::vector<test::Patch> patches = test::box(X_CB, kSize);
    patches.push_back(test::rectangle(X_CW, 1.2, 1.0));
    patches.insert(patches.end(), more.begin(), more.end());
    cloud = test::render(patches, {640, 480, 1.0 / 600.0, 0.001});
    found = detect(cloud);
  }
  GraspPlan plan(const PlanOptions& options = {}) const {
    return plan_grasps(cloud, found.detections, franka_hand(), options, {}, {}, found.boxes);
  }
};

const BoxScene& scene() {
  static const BoxScene box;
  return box;
}

TEST_CASE("a box on a table is grasped across two parallel faces", "[plan][boxes]") {
  const GraspPlan plan = scene().plan();
  REQUIRE(plan.boxes.size() == 1);
  CHECK(plan.boxes[0].id == scene().found.boxes[0].id);
  std::vector<Grasp> grasps = plan.grasps;
  std::erase_if(grasps, [&](const Grasp& g) { return g.target != plan.boxes[0].id; });
  REQUIRE(!grasps.empty());
  for (const Grasp& grasp : grasps) {
    // On the true faces, which the closing direction is normal to.
    const Eigen::Vector3d d = scene().X_CB.linear().transpose() * grasp.X_CG.linear().col(1);
    int axis = 0;
    CHECK(d.cwiseAbs().maxCoeff(&axis) > 0.99);
    CHECK(grasp.width == Approx(kSize[axis]).margin(0.005));
    for (const Eigen::Vector3d& p_C : grasp.contacts_C) {
      const Eigen::Vector3d p_B = scene().X_CB.inverse() * p_C;
      CHECK(std::abs(p_B[axis]) == Approx(0.5 * kSize[axis]).margin(0.004));
      for (int k = 0; k < 3; ++k) CHECK(std::abs(p_B[k]) < 0.5 * kSize[k] + 0.004);
    }
    CHECK(grasp.preshape > grasp.width);
  }
}

TEST_CASE("the planner takes the detector's boxes, however far the cloud is from the origin",
          "[plan][boxes]") {
  const Eigen::Vector3d shift = GENERATE(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(800, -300, 40));
  PointCloud cloud = scene().cloud;
  for (Eigen::Vector3f& p : cloud.points) p += shift.cast<float>();
  cloud.viewpoint += shift;
  const DetectionResult found = detect(cloud);
  const GraspPlan plan =
      plan_grasps(cloud, found.detections, franka_hand(), {}, {}, {}, found.boxes);
  REQUIRE(found.boxes.size() == 1);
  REQUIRE(plan.boxes.size() == 1);
  const Box &a = found.boxes[0], &b = plan.boxes[0];
  CHECK(a.id == b.id);
  CHECK(a.faces == b.faces);
  CHECK(a.X_CB.matrix() == b.X_CB.matrix());
  CHECK(a.size == b.size);
  CHECK(a.std == b.std);
  CHECK(a.seen == b.seen);
  CHECK((a.inner_B.min() == b.inner_B.min() && a.inner_B.max() == b.inner_B.max()));
  CHECK((a.outer_B.min() == b.outer_B.min() && a.outer_B.max() == b.outer_B.max()));
}

TEST_CASE("a box has one collision shape in place of its faces", "[plan][boxes][shape]") {
  const GraspPlan plan = scene().plan();
  REQUIRE(plan.boxes.size() == 1);
  const Box& box = plan.boxes[0];
  int shapes = 0;
  for (const CollisionShape& shape : plan.shapes) {
    CHECK(std::find(box.faces.begin(), box.faces.end(), shape.target) == box.faces.end());
    if (shape.target != box.id) continue;
    ++shapes;
    CHECK(shape.kind == "box");
    REQUIRE(shape.dimensions.size() == 3);
    for (int i = 0; i < 3; ++i) CHECK(shape.dimensions[i] == Approx(box.size[i]));
    CHECK(shape.X_CS.isApprox(box.X_CB));
    CHECK(shape.geometry != nullptr);
  }
  CHECK(shapes == 1);
}

TEST_CASE("a wall beside a box keeps the hand out", "[plan][boxes][collision]") {
  // Four walls around the box, 8 mm from it and twice as high: no finger fits between.
  std::vector<test::Patch> walls;
  const double gap = 0.008, thick = 0.01, height = 0.14;
  for (const int axis : {0, 1}) {
    for (const double side : {-1.0, 1.0}) {
      Eigen::Vector3d size(kSize.x() + 0.06, kSize.y() + 0.06, height);
      Eigen::Vector3d at(0, 0, 0.5 * (height - kSize.z()));
      size[axis] = thick;
      at[axis] = side * (0.5 * kSize[axis] + gap + 0.5 * thick);
      for (const test::Patch& p :
           test::box(scene().X_CB * Eigen::Isometry3d(Eigen::Translation3d(at)), size)) {
        walls.push_back(p);
      }
    }
  }
  const BoxScene walled(walls);
  for (const Grasp& grasp : walled.plan().grasps) {
    const Eigen::Vector3d p_B = walled.X_CB.inverse() * grasp.X_CG.translation();
    CHECK_FALSE((p_B.cwiseAbs().array() < 0.5 * kSize.array()).all());
  }
}

}  // namespace
}  // namespace quadrille
