#include "quadrille/grasping/conventions.hpp"

#include <random>

#include "grasping/scenes.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3d;

namespace {

Eigen::Isometry3d in_grasp(HandConvention convention) {
  return hand_in_grasp(convention, franka_hand(), 0.05);
}

}  // namespace

TEST_CASE("a hand's pose and its grasp are each other's inverse in every convention",
          "[conventions]") {
  std::mt19937 random(7);
  for (const HandConvention convention : kHandConventions) {
    CAPTURE(to_string(convention));
    for (int i = 0; i < 200; ++i) {
      const Eigen::Isometry3d X_CG = test::random_pose(random);
      const double width = test::uniform(random, 0.0, 0.08);
      const Eigen::Isometry3d X_CH = hand_pose(convention, franka_hand(), X_CG, width);
      CHECK(X_CH.linear().determinant() == Approx(1.0));
      CHECK(grasp_of_hand(convention, franka_hand(), X_CH, width).isApprox(X_CG, 1e-12));
    }
  }
}

TEST_CASE("approach and closing lie along the axes that each convention names", "[conventions]") {
  const Vector3d approach = Vector3d::UnitZ(), closing = Vector3d::UnitY();
  const auto axis = [](HandConvention convention, int column) -> Vector3d {
    return in_grasp(convention).linear().col(column);
  };
  CHECK(axis(HandConvention::kDrake, 1) == approach);
  CHECK(axis(HandConvention::kDrake, 0) == closing);
  CHECK(axis(HandConvention::kMoveit, 2) == approach);
  CHECK(axis(HandConvention::kMoveit, 1) == closing);
  CHECK(axis(HandConvention::kGpd, 0) == approach);
  CHECK(axis(HandConvention::kGpd, 1) == closing);
  CHECK(axis(HandConvention::kGraspnet, 0) == approach);
  CHECK(axis(HandConvention::kGraspnet, 1) == closing);
}

TEST_CASE("the hand's origin lies behind the pads by what each convention names", "[conventions]") {
  const auto back = [](HandConvention convention) {
    const Vector3d p = in_grasp(convention).translation();
    CHECK(p.head<2>().isZero());
    return -p.z();
  };
  CHECK(back(HandConvention::kMoveit) == Approx(0.1034));
  CHECK(back(HandConvention::kDrake) == Approx(0.1034));
  CHECK(back(HandConvention::kGpd) == Approx(0.045));
  CHECK(back(HandConvention::kGraspnet) == 0.0);
  Gripper plain = franka_hand();
  plain.tcp = 0.0;
  CHECK(-hand_in_grasp(HandConvention::kMoveit, plain, 0.05).translation().z() ==
        Approx(0.045 + 0.066));
}

TEST_CASE("fingers on links move the hand back as they close", "[conventions]") {
  Gripper hand = franka_hand();
  hand.link_length = 0.06;
  hand.link_angle = 0.7;
  const auto back = [&](HandConvention convention, double width) {
    return -hand_in_grasp(convention, hand, width).translation().z();
  };
  const double shift = hand.extension(0.02);
  CHECK(shift > 0.005);
  CHECK(back(HandConvention::kMoveit, hand.max_opening) == Approx(0.1034));
  CHECK(back(HandConvention::kMoveit, 0.02) == Approx(0.1034 + shift));
  CHECK(back(HandConvention::kGpd, 0.02) == Approx(0.045 + shift));
  CHECK(back(HandConvention::kGraspnet, 0.02) == 0.0);
}
