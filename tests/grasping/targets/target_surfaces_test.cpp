#include "targets/target_surfaces.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "grasping/scenes.hpp"
#include "support/catch.hpp"
#include "targets/scene_parts.hpp"
#include "targets/target_order.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

SupportPlane plane_facing_camera(double z) {
  SupportPlane plane;
  plane.X_CP.linear() = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  plane.X_CP.translation().z() = z;
  return plane;
}

Target ball_above(const Ball& ball, double plane_z) {
  Target target;
  target.body = make_body(sphere_detection(ball)).value();
  target.supports = {plane_facing_camera(plane_z)};
  return target;
}

/// A scene with targets among points on a grid: two balls on one plane, a third on another one.
struct ScenePoints {
  SceneParts parts;
  std::vector<DepthView> views;

  ScenePoints() {
    parts.gripper = franka_hand();
    parts.targets = {ball_above({{0.0, 0.0, 0.7}, 0.02}, 0.72),
                     ball_above({{0.1, 0.0, 0.7}, 0.02}, 0.72),
                     ball_above({{0.0, 0.1, 0.7}, 0.02}, 0.75)};
    // The second ball stands on the plane of the first one, which is given by another of its
    // points.
    parts.targets[1].supports.front().X_CP.translation().x() = 0.3;
    PointCloud cloud;
    for (double x = -0.2; x < 0.3; x += 0.002) {
      for (double y = -0.2; y < 0.3; y += 0.002) {
        cloud.points.emplace_back(Eigen::Vector3d(x, y, 0.7 + 0.2 * y).cast<float>());
      }
    }
    views.emplace_back(cloud);
    parts.views = views;
    parts.points.shared_C = std::make_shared<const std::vector<Eigen::Vector3f>>(cloud.points);
    parts.points.p_C = *parts.points.shared_C;
    parts.points.view.assign(cloud.points.size(), 0);
    parts.points.runs = CloudRuns(parts.points.p_C);
    parts.surfaces = TargetSurfaces(parts.targets);
  }
  const PointSurface& about(std::size_t target) const {
    return parts.surfaces.about(parts.targets[target], parts);
  }
};

}  // namespace

TEST_CASE("targets on the same support share a surface, others do not", "[targets][points]") {
  const ScenePoints scene;
  CHECK(&scene.about(0) == &scene.about(1));
  CHECK(&scene.about(0) != &scene.about(2));
}

TEST_CASE("the surface about targets shows no points of their supports", "[targets][points]") {
  const ScenePoints scene;
  const auto lowest = [&](std::size_t target) {
    double z = 0.0;
    for (const Eigen::Vector3d& p_C : scene.about(target).all().p_C) z = std::max(z, p_C.z());
    return z;
  };
  // Points up to 6 mm above a plane belong to it.
  CHECK(lowest(0) == Approx(0.714).margin(0.0005));
  CHECK(lowest(2) > 0.73);
}

TEST_CASE("the target with most points about it is tried first", "[targets][threads]") {
  ScenePoints scene;
  scene.parts.targets[1].body = make_body(sphere_detection({{0.05, 0.05, 0.7}, 0.08})).value();
  scene.parts.targets[0].body = make_body(sphere_detection({{0.0, 0.0, 5.0}, 0.02})).value();
  const std::vector<const Target*> targets = {&scene.parts.targets[0], &scene.parts.targets[1],
                                              &scene.parts.targets[2]};
  CHECK(costliest_first(targets, scene.parts) == std::vector<int>{1, 2, 0});
  CHECK(as_given(3) == std::vector<int>{0, 1, 2});
}
