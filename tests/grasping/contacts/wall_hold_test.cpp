#include "contacts/wall_hold.hpp"

#include <cmath>
#include <stdexcept>

#include "contacts/rim.hpp"
#include "grasping/cup.hpp"
#include "grasping/plans.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kHalfWidth = 0.009;

/// The wall of each solid that has one, its rim where there is still room above the contacts.
Shell shell_of_type(QuadricType type) {
  for (const Detection& d : solid_detections()) {
    if (d.type != type) continue;
    Shell shell{make_body(d).value(), false, {}};
    if (shell.body.profile == Body::Profile::kEllipse) shell.body.z_max = 0.5 * shell.body.c;
    return shell;
  }
  throw std::logic_error("no such solid");
}

/// The approach that lies askew on the wall by an angle.
Eigen::Vector3d askew(const Shell& shell, const ContactLine& line, double angle) {
  const Eigen::Vector3d into = along_wall(line, -shell.body.X_CQ.linear().col(2));
  return std::cos(angle) * into + std::sin(angle) * line.closing_C.cross(into);
}

double warp_of(QuadricType type, double angle) {
  const Shell shell = shell_of_type(type);
  const ContactLine line = rim_lines(shell, franka_hand()).front();
  const Eigen::Vector3d approach = askew(shell, line, angle);
  const double warp = wall_warp(shell, line, approach, kHalfWidth);
  // The same line along the wall, from below.
  CHECK(wall_warp(shell, line, -approach, kHalfWidth) == Approx(warp).margin(1e-12));
  return warp;
}

}  // namespace

TEST_CASE("a hand along a wall closes across it and comes down its steepest line", "[wall_hold]") {
  for (const QuadricType type : {QuadricType::kCylinder, QuadricType::kEllipticCone,
                                 QuadricType::kHyperboloidOneSheet, QuadricType::kSphere}) {
    const Shell shell = shell_of_type(type);
    const Eigen::Vector3d into = -shell.body.X_CQ.linear().col(2);
    for (const ContactLine& line : rim_lines(shell, franka_hand())) {
      const Eigen::Vector3d along = along_wall(line, into);
      CHECK(along.dot(line.closing_C) == Approx(0.0).margin(1e-9));
      CHECK(along.dot(into.cross(line.closing_C)) == Approx(0.0).margin(1e-9));
      CHECK(along.dot(into) > 0.0);
    }
  }
}

TEST_CASE("the rim lies as far above the contacts as a way up the wall is long", "[wall_hold]") {
  for (const QuadricType type : {QuadricType::kCylinder, QuadricType::kCone}) {  // straight walls
    const Shell shell = shell_of_type(type);
    for (const ContactLine& line : rim_lines(shell, franka_hand())) {
      const Eigen::Vector3d p = shell.body.X_CQ.inverse() * line.contacts_C[0];
      const double angle = std::atan2(p.y() / shell.body.b, p.x() / shell.body.a);
      const Eigen::Vector3d rim = shell.point_Q(angle, shell.body.z_max);
      CHECK(rim_above(shell, line) == Approx((rim - p).norm()));
    }
  }
}

TEST_CASE("walls are warped by the difference of their bends times sin φ cos φ", "[wall_hold]") {
  const double bite = rim_above(shell_of_type(QuadricType::kCylinder),
                                rim_lines(shell_of_type(QuadricType::kCylinder), franka_hand())[0]);
  for (const double angle : {-0.5, -0.2, 0.0, 0.1, 0.3, 0.6}) {
    CAPTURE(angle);
    const double share = std::abs(std::sin(angle) * std::cos(angle));
    CHECK(warp_of(QuadricType::kCylinder, angle) ==
          Approx(share / 0.03 * kHalfWidth * bite).epsilon(0.01).margin(1e-9));
    // A ball bends alike in all directions.
    CHECK(warp_of(QuadricType::kSphere, angle) < 1e-5);
    // A waist bends the other way along its axis.
    if (share > 0.0) {
      CHECK(warp_of(QuadricType::kHyperboloidOneSheet, angle) >
            1.2 * warp_of(QuadricType::kCylinder, angle));
    }
  }
}

TEST_CASE("hands lie straight on a rim, their tips as far below the contacts as the rim is above",
          "[wall_hold][plan]") {
  const Cup cup;
  const Eigen::Vector3d into = -table_detection().X_CQ.linear().col(2);
  const Eigen::Isometry3d X_TC = table_detection().X_CQ.inverse();
  for (const bool inner : {false, true}) {
    const GraspPlan plan = plan_grasps(render(cup), {wall_detection(cup, inner), table_detection()},
                                       franka_hand(), with(UnknownPolicy::kFree));
    REQUIRE_FALSE(plan.grasps.empty());
    CHECK(plan.grasps.front().X_CG.linear().col(2).dot(into) > std::cos(0.03));
    for (const Grasp& grasp : plan.grasps) {
      const double tips = (X_TC * (grasp.X_CG * Eigen::Vector3d(0, 0, 0.009))).z();
      const double middle = (X_TC * grasp.contacts_C[0]).z();
      CHECK(cup.height - middle == Approx(middle - tips).margin(0.002));
    }
  }
}
