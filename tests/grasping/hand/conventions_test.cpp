#include "quadrille/grasping/conventions.hpp"

#include <random>

#include "grasping/scenes.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3d;

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

TEST_CASE("axes and origin of the hand lie where each convention has them", "[conventions]") {
  struct Row {
    HandConvention convention;
    int approach, closing;
    double back;
  };
  for (const Row& row :
       {Row{HandConvention::kDrake, 1, 0, 0.1034}, Row{HandConvention::kMoveit, 2, 1, 0.1034},
        Row{HandConvention::kGpd, 0, 1, 0.045}, Row{HandConvention::kGraspnet, 0, 1, 0.0}}) {
    CAPTURE(to_string(row.convention));
    const Eigen::Isometry3d X_GH = hand_in_grasp(row.convention, franka_hand(), 0.05);
    CHECK(Vector3d(X_GH.linear().col(row.approach)) == Vector3d::UnitZ());
    CHECK(Vector3d(X_GH.linear().col(row.closing)) == Vector3d::UnitY());
    CHECK(X_GH.translation().head<2>().isZero());
    CHECK(X_GH.translation().z() == Approx(-row.back));
  }
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
