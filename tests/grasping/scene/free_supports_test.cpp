#include "scene/free_supports.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "grasping/mapped_scene.hpp"
#include "grasping/plans.hpp"
#include "hand/hand.hpp"
#include "space/support.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Two balls on a table, and the parts that tell what the balls stand on.
struct StandingScene {
  Scene scene;
  SceneParts parts;

  explicit StandingScene(double noise = 0.0) {
    parts.space = std::make_shared<OccupancyGrid>(scene.grid);
    parts.points.p_C = scene.cloud.points;
    Detection table = table_detection();
    table.rms = noise;
    for (const Ball& ball : scene.balls) {
      Target& target = parts.targets.emplace_back();
      target.body = *make_body(sphere_detection(ball));
      target.supports = supports_of(target.body, {table});
    }
  }
  ObstacleMap freed() {
    ObstacleMap map(*parts.space, false);
    free_supports(&parts, &map);
    return map;
  }
};

double height(const Eigen::Vector3f& p_C) {
  return (table_detection().X_CQ.inverse() * p_C.cast<double>()).z();
}

}  // namespace

TEST_CASE("the voxels of a table give way, and those of the things on it do not",
          "[supports][occupancy]") {
  StandingScene standing;
  const ObstacleMap before(*standing.parts.space, false), after = standing.freed();
  int table = 0, things = 0;
  for (const Eigen::Vector3f& p_C : standing.scene.cloud.points) {
    const Eigen::Vector3d p = p_C.cast<double>();
    if (!before.is_occupied(p)) continue;
    const Eigen::Vector3d here = table_detection().X_CQ.inverse() * p;
    // Farther from the middle than the two balls and a voxel reach.
    const bool beside = std::hypot(here.x() - 0.045, here.y() - 0.01) > 0.09;
    if (height(p_C) > 0.002) {
      CHECK(after.is_occupied(p));
      ++things;
    } else if (beside) {
      CHECK_FALSE(after.is_occupied(p));
      ++table;
    }
  }
  CHECK(table > 1000);
  CHECK(things > 400);
}

TEST_CASE("what lies on a table is told from it if it is higher than the noise",
          "[supports][occupancy]") {
  const double lift = GENERATE(0.0015, 0.004, 0.007), noise = GENERATE(0.0, 0.001, 0.002);
  StandingScene standing(noise);
  // A part of the table is moved up, along the rays of the sensor: a sheet that lies on it.
  const Detection table = table_detection();
  const Eigen::Vector3d n = table.X_CQ.linear().col(2);
  PointCloud cloud = standing.scene.cloud;
  std::vector<Eigen::Vector3d> sheet;
  for (Eigen::Vector3f& p : cloud.points) {
    const Eigen::Vector3d p_C = p.cast<double>(), here = table.X_CQ.inverse() * p_C;
    // Missing points are NaN.
    const bool on_patch =
        here.z() < 1e-3 && std::abs(here.x() + 0.09) < 0.02 && std::abs(here.y()) < 0.02;
    if (!on_patch) continue;
    sheet.push_back(p_C * ((n.dot(table.X_CQ.translation()) + lift) / n.dot(p_C)));
    p = sheet.back().cast<float>();
  }
  REQUIRE(sheet.size() > 60);
  standing.parts.space = std::make_shared<OccupancyGrid>(map_of(cloud, DepthView(cloud)));
  standing.parts.points.p_C = cloud.points;
  const ObstacleMap map = standing.freed();
  const auto occupied = std::count_if(sheet.begin(), sheet.end(),
                                      [&](const auto& p_C) { return map.is_occupied(p_C); });
  const double share = static_cast<double>(occupied) / static_cast<double>(sheet.size());
  CAPTURE(lift, noise, share);
  CHECK((lift > std::max(0.002, 3.0 * noise) ? share > 0.9 : share == 0.0));
}

TEST_CASE("on a noisy plane no hand comes nearer than its points lie apart", "[supports][plan]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.016);
  const Eigen::Vector3d up_C = table_detection().X_CQ.linear().col(2);
  const double table_height = up_C.dot(table_detection().X_CQ.translation());
  const auto lowest = [&](double rms) {
    std::vector<Detection> detections = detections_of({ball});
    detections[0].rms = rms;
    double least = 1.0;
    for (const Grasp& grasp : plan_grasps(render({ball}), detections, franka_hand()).grasps) {
      const SweptHand hand =
          sweep_hand(franka_hand(), grasp.X_CG, grasp.preshape, grasp.width, grasp.approach);
      for (const OrientedBox& box : {hand.fingers[0], hand.fingers[1], hand.palm}) {
        least = std::min(least, -box.support(-up_C) - table_height);
      }
    }
    return least;
  };
  const double smooth = lowest(0.0), noisy = lowest(0.002);
  CHECK(smooth > 0.002);
  CHECK(smooth < 0.006);
  CHECK(noisy > 0.006);
  CHECK(noisy < 1.0);
}

TEST_CASE("voxels give way to a table only where the table was seen", "[supports][occupancy]") {
  StandingScene standing;
  Detection table = table_detection();
  // The points beyond belong to something else, which is as high.
  table.extent_Q.max().x() = 0.0;
  for (Target& target : standing.parts.targets) {
    target.supports = supports_of(target.body, {table});
    REQUIRE(target.supports.size() == 1);
  }
  const ObstacleMap before(*standing.parts.space, false), after = standing.freed();
  int seen = 0, beyond = 0;
  for (const Eigen::Vector3f& p_C : standing.scene.cloud.points) {
    const Eigen::Vector3d p = p_C.cast<double>();
    if (!before.is_occupied(p) || height(p_C) > 0.002) continue;
    const double x = (table.X_CQ.inverse() * p).x();
    // The first ball and a voxel reach less far to the one side, and a voxel to the other.
    if (x < -0.04) {
      CHECK_FALSE(after.is_occupied(p));
      ++seen;
    } else if (x > 0.01) {
      CHECK(after.is_occupied(p));
      ++beyond;
    }
  }
  CHECK(seen > 500);
  CHECK(beyond > 500);
}
