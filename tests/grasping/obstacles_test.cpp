// Obstacles that the user knows of.
#include <algorithm>
#include <cmath>
#include <limits>

#include "grasping/plans.hpp"
#include "hand/hand.hpp"
#include "quadrille/grasping/shape.hpp"
#include "support/error_of.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

CollisionShape box_at(const Eigen::Vector3d& p_C, const Eigen::Vector3d& size) {
  CollisionShape shape;
  shape.kind = "box";
  shape.X_CS.linear() = table_detection().X_CQ.linear();
  shape.X_CS.translation() = p_C;
  shape.dimensions = {size.x(), size.y(), size.z()};
  return with_geometry(shape);
}

GraspPlan plan_with(const Ball& ball, const std::vector<CollisionShape>& obstacles) {
  GraspQuery query;
  query.obstacles = obstacles;
  return plan_grasps(render({ball}), detections_of({ball}), franka_hand(),
                     with(UnknownPolicy::kFree), {}, query);
}

/// Returns true if a part of the hand on its way in, sampled every 2 mm, lies in the obstacle.
bool touches(const Grasp& grasp, const CollisionShape& obstacle) {
  const SweptHand hand =
      sweep_hand(franka_hand(), grasp.X_CG, grasp.preshape, grasp.width, grasp.approach);
  const Eigen::Vector3d size(obstacle.dimensions.data());
  for (const OrientedBox& box : {hand.fingers[0], hand.fingers[1], hand.palm}) {
    const Eigen::Vector3i steps = (box.half / 0.001).cast<int>();
    for (int i = -steps.x(); i <= steps.x(); i += 2) {
      for (int j = -steps.y(); j <= steps.y(); j += 2) {
        for (int k = -steps.z(); k <= steps.z(); k += 2) {
          const Eigen::Vector3d p_C = box.p_CB + box.R_CB * (0.001 * Eigen::Vector3d(i, j, k));
          const Eigen::Vector3d p_S = obstacle.X_CS.inverse() * p_C;
          if ((p_S.cwiseAbs().array() < 0.5 * size.array()).all()) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace

TEST_CASE("the hand keeps off obstacles that the cloud does not show", "[plan][obstacles]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.03);
  const Eigen::Vector3d up = table_detection().X_CQ.linear().col(2);
  // A fence beside the ball: hands that come from there touch it.
  const CollisionShape fence =
      box_at(ball.p_C + Eigen::Vector3d(0.06, 0.0, 0.0) + 0.05 * up, {0.01, 0.4, 0.3});
  const GraspPlan free = plan_with(ball, {}), fenced = plan_with(ball, {fence});
  REQUIRE_FALSE(fenced.grasps.empty());
  CHECK(std::any_of(free.grasps.begin(), free.grasps.end(),
                    [&](const Grasp& grasp) { return touches(grasp, fence); }));
  CHECK(std::none_of(fenced.grasps.begin(), fenced.grasps.end(),
                     [&](const Grasp& grasp) { return touches(grasp, fence); }));
  // Nothing is left if the whole ball is walled in.
  const GraspPlan walled = plan_with(ball, {box_at(ball.p_C, {0.2, 0.2, 0.2})});
  CHECK(walled.grasps.empty());
  CHECK(walled.rejected.at("collision") > 0);
}

TEST_CASE("obstacles move with their query", "[plan][obstacles]") {
  GraspQuery query;
  query.obstacles = {box_at({0.1, 0.2, 0.7}, {0.1, 0.1, 0.1})};
  const Eigen::Isometry3d X_FC = Eigen::Translation3d(1.0, -2.0, 0.5) *
                                 Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  const GraspQuery there = moved(query, X_FC);
  CHECK(there.obstacles[0].X_CS.isApprox(X_FC * query.obstacles[0].X_CS));
}

TEST_CASE("shapes that make no sense are refused with the reason", "[shape][obstacles]") {
  const auto error = [](const std::string& kind, const std::vector<double>& dimensions) {
    CollisionShape shape;
    shape.kind = kind;
    shape.dimensions = dimensions;
    return error_of([&] { with_geometry(shape); });
  };
  CHECK(error("sphere", {0.1}).empty());
  CHECK(error("cone", {0.1, 0.2}).empty());
  CHECK(error("ellipsoid", {0.1, 0.2, 0.3}).empty());
  CHECK(error("cylinder", {0.1}).find("2 sizes") != std::string::npos);
  CHECK(error("box", {0.1, 0.2, -0.3}).find("more than 0") != std::string::npos);
  CHECK(error("box", {0.1, 0.2, std::nan("")}).find("more than 0") != std::string::npos);
  CHECK(error("torus", {0.1}).find("must be sphere") != std::string::npos);
  CollisionShape skew;
  skew.kind = "sphere";
  skew.dimensions = {0.1};
  skew.X_CS.linear() *= 2.0;
  CHECK(error_of([&] { with_geometry(skew); }).find("rigid") != std::string::npos);

  CollisionShape convex;
  convex.kind = "convex";
  convex.vertices_S = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  const std::vector<int> faces = {3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3};
  convex.faces = faces;
  CHECK(error_of([&] { with_geometry(convex); }).empty());
  convex.faces.back() = 4;
  CHECK(error_of([&] { with_geometry(convex); }).find("vertex") != std::string::npos);
  convex.faces = faces;
  convex.faces.pop_back();
  CHECK(error_of([&] { with_geometry(convex); }).find("corners") != std::string::npos);
  convex.faces = faces;
  convex.faces[0] = std::numeric_limits<int>::max();
  CHECK(error_of([&] { with_geometry(convex); }).find("corners") != std::string::npos);
  convex.faces = {3, 0, 1, 2};
  CHECK(error_of([&] { with_geometry(convex); }).find("solid") != std::string::npos);

  GraspQuery query;
  query.obstacles.resize(1);
  CHECK(error_of([&] { query.check(); }).find("with_geometry") != std::string::npos);
}
