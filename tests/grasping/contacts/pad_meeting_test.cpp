#include "contacts/pad_meeting.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "contacts/candidates.hpp"
#include "contacts/quality.hpp"
#include "grasping/scenes.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX(), kZ = Eigen::Vector3d::UnitZ();

Body cylinder(double radius, double length) {
  return make_body(cylinder_detection(Eigen::Isometry3d::Identity(), radius, length)).value();
}

/// True if the line through a point of the body along the closing direction leaves it away from its
/// flat ends. Where these cut chords off, more of the body may lie between two chords of the grid,
/// which are up to 9 mm apart.
bool off_ends(const Body& body, const Eigen::Vector3d& p_C, const Eigen::Vector3d& closing_C) {
  if (!body.contains(p_C)) return false;
  const auto line = chord(body, p_C, closing_C);
  if (!line) return false;
  if (body.profile == Body::Profile::kEllipse) return true;
  return std::all_of(line->contacts_C.begin(), line->contacts_C.end(), [&](const auto& end_C) {
    const double z = (body.X_CQ.inverse() * end_C).z();
    return z > body.z_min + 0.009 && z < body.z_max - 0.009;
  });
}

}  // namespace

TEST_CASE("pads that reach over the middle of a cylinder meet its sides", "[pads]") {
  const Body body = cylinder(0.03, 0.1);
  const Gripper hand = franka_hand();
  PadMeetingFinder finder(body, hand, kX, -kZ);
  const auto meeting = finder.at({0.005, 0.0, 0.02});
  REQUIRE(meeting);
  const ContactLine& line = meeting->line;
  CHECK(line.width == Approx(0.06).epsilon(1e-5));
  CHECK((line.centre_C - Eigen::Vector3d(0.0, 0.0, 0.02)).norm() < 1e-6);
  CHECK((line.normals_C[0] - kX).norm() < 1e-6);
  CHECK((line.normals_C[1] + kX).norm() < 1e-6);
  // Beside the contacts the sides lean by as much as 8.75 mm on 30 mm: by half of that in the mean.
  CHECK(meeting->friction < 0.25);
}

TEST_CASE("tips above the equator of a ball meet it where they end", "[pads]") {
  const double radius = 0.04, height = 0.015;
  const Body body = make_body(sphere_detection({{0, 0, 0}, radius})).value();
  const Gripper hand = franka_hand();
  PadMeetingFinder finder(body, hand, kX, -kZ);
  const auto meeting = finder.at({0.0, 0.0, height + hand.finger_front});
  REQUIRE(meeting);
  const double half = std::sqrt(radius * radius - height * height);
  CHECK(meeting->line.width == Approx(2.0 * half).epsilon(1e-5));
  CHECK(meeting->line.contacts_C[0].z() == Approx(height).margin(1e-6));
  CHECK(friction_needed(meeting->line) == Approx(height / half).epsilon(1e-4));
  CHECK(meeting->friction >= friction_needed(meeting->line));
}

TEST_CASE("pads that reach beside a body, or that it is too wide for, do not meet it", "[pads]") {
  const Gripper hand = franka_hand();
  const Body wide = cylinder(0.041, 0.1), narrow = cylinder(0.03, 0.1);
  PadMeetingFinder wide_finder(wide, hand, kX, -kZ), finder(narrow, hand, kX, -kZ);
  CHECK_FALSE(wide_finder.at(Eigen::Vector3d::Zero()));
  CHECK_FALSE(finder.at({0.0, 0.05, 0.0}));
  CHECK_FALSE(finder.at({0.0, 0.0, 0.2}));
  CHECK(finder.at(Eigen::Vector3d::Zero()));
}

TEST_CASE("pads that lean out over the end of a body meet its edge, which is no hold", "[pads]") {
  const Body body = cylinder(0.02, 0.06);
  const Eigen::Vector3d closing = (kX + 0.2 * kZ).normalized();
  const Gripper hand = franka_hand();
  PadMeetingFinder finder(body, hand, closing, closing.cross(Eigen::Vector3d::UnitY()));
  const auto middle = finder.at(Eigen::Vector3d::Zero());
  REQUIRE(middle);
  REQUIRE(middle->line.closing_C == closing);
  CHECK_FALSE(finder.at({0.0, 0.0, 0.03}));
}

TEST_CASE("no point of a body lies between the fingers beyond where they meet it", "[pads][law]") {
  std::mt19937 random(61);
  const Gripper hand = franka_hand();
  int met = 0;
  std::map<QuadricType, int> inside;
  for (Detection d : solid_detections()) {
    if (d.type == QuadricType::kParallelPlanes) continue;
    d.X_CQ = random_pose(random);
    const Body body = make_body(d).value();
    for (int n = 0; n < 1500; ++n) {
      const Eigen::Matrix3d R = random_rotation(random);
      PadMeetingFinder finder(body, hand, R.col(1), R.col(2));
      // On steeper sides, which no friction holds, more lies between two chords of the grid.
      const auto meeting = finder.at(random_point(random, body.bounds_C()), 0.5);
      if (!meeting) continue;
      ++met;
      const ContactLine& line = meeting->line;
      const Eigen::Isometry3d X_GC = grasp_pose(line, R.col(2), 0.0).inverse();
      for (int i = 0; i < 2; ++i) {
        CHECK(body.contains(line.contacts_C[i], 1e-6));
        const Eigen::Vector3d p_G = X_GC * line.contacts_C[i];
        CHECK(p_G.y() == Approx((i == 0 ? 0.5 : -0.5) * line.width).margin(1e-5));
      }
      for (int k = 0; k < 300; ++k) {
        const Eigen::Vector3d p_C = random_point(random, body.bounds_C());
        const Eigen::Vector3d p_G = X_GC * p_C;
        const bool between = std::abs(p_G.x()) < 0.5 * hand.finger.x() &&
                             p_G.z() < hand.finger_front &&
                             p_G.z() > hand.finger_front - hand.finger.z();
        if (!between || !off_ends(body, p_C, line.closing_C)) continue;
        ++inside[d.type];
        CHECK(std::abs(p_G.y()) < 0.5 * line.width + 0.002);
      }
    }
  }
  CHECK(met > 50);
  for (const QuadricType type :
       {QuadricType::kSphere, QuadricType::kEllipsoid, QuadricType::kCylinder, QuadricType::kCone,
        QuadricType::kEllipticParaboloid, QuadricType::kHyperboloidOneSheet}) {
    CAPTURE(to_string(type));
    CHECK(inside[type] > 50);
  }
}
