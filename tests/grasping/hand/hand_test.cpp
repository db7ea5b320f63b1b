#include "hand/hand.hpp"

#include <algorithm>
#include <array>
#include <random>

#include "grasping/scenes.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kPreshape = 0.07, kClosed = 0.05, kApproach = 0.06;

/// The hand itself, at rest: its solid parts with the pads that far apart.
std::array<OrientedBox, 3> hand_at(const Gripper& g, const Eigen::Isometry3d& X_CG,
                                   double opening) {
  const double tip = g.finger_front, back = tip - g.finger.z(), x = 0.5 * g.finger.x();
  const double in = 0.5 * opening, out = in + g.finger.y();
  return {box_between(X_CG, {-x, in, back}, {x, out, tip}),
          box_between(X_CG, {-x, -out, back}, {x, -in, tip}),
          box_between(X_CG, {-0.5 * g.palm.x(), -0.5 * g.palm.y(), back - g.palm.z()},
                      {0.5 * g.palm.x(), 0.5 * g.palm.y(), back})};
}

std::array<Gripper, 3> hands() {
  Gripper swinging = franka_hand();
  swinging.link_length = 0.06;
  swinging.link_angle = 0.6;
  return {franka_hand(), schunk_wsg50(), swinging};
}

Eigen::Vector3d random_in(std::mt19937& random, const OrientedBox& box) {
  return box.p_CB + box.R_CB * random_point(random, {-box.half, box.half});
}

}  // namespace

TEST_CASE("a swept hand holds every point that the hand passes", "[hand]") {
  std::mt19937 random(31);
  for (const Gripper& gripper : {franka_hand(), schunk_wsg50()}) {
    const Eigen::Isometry3d X_CG = random_pose(random);
    const SweptHand swept = sweep_hand(gripper, X_CG, kPreshape, kClosed, kApproach);
    for (int n = 0; n < 2000; ++n) {
      Eigen::Isometry3d X = X_CG;
      X.translation() -= uniform(random, 0.0, kApproach) * X_CG.linear().col(2);
      const auto coming = hand_at(gripper, X, kPreshape);
      for (std::size_t i = 0; i < 2; ++i) {
        REQUIRE(swept.fingers[i].inflated(1e-9).contains(random_in(random, coming[i])));
      }
      REQUIRE(swept.palm.inflated(1e-9).contains(random_in(random, coming[2])));
      // Closing: the inner faces move from the pre-shape to the width.
      const auto closing = hand_at(gripper, X_CG, uniform(random, kClosed, kPreshape));
      for (std::size_t i = 0; i < 2; ++i) {
        const Eigen::Vector3d p = random_in(random, closing[i]);
        REQUIRE((swept.fingers[i].inflated(1e-9).contains(p) ||
                 swept.closing[i].inflated(1e-9).contains(p)));
      }
    }
  }
}

TEST_CASE("and no more than that: its volume is that of the parts times their ways", "[hand]") {
  const Gripper g = franka_hand();
  const SweptHand swept =
      sweep_hand(g, Eigen::Isometry3d::Identity(), kPreshape, kClosed, kApproach);
  const auto volume = [](const OrientedBox& box) { return 8.0 * box.half.prod(); };
  const Eigen::Vector3d way(0, 0, kApproach);
  CHECK(volume(swept.palm) == Approx((g.palm + way).prod()));
  for (int i = 0; i < 2; ++i) {
    CHECK(volume(swept.fingers[i]) == Approx((g.finger + way).prod()));
    CHECK(volume(swept.closing[i]) ==
          Approx(g.finger.x() * g.finger.z() * 0.5 * (kPreshape - kClosed)));
  }
}

TEST_CASE("a hand that does not close passes no space while closing", "[hand]") {
  const SweptHand swept =
      sweep_hand(franka_hand(), Eigen::Isometry3d::Identity(), kClosed, kClosed + 0.01, 0.0);
  for (const OrientedBox& box : swept.closing) CHECK(box.half.y() == Approx(0.0).margin(1e-12));
}

TEST_CASE("what fingers have in common lies in what each such hand passes", "[hand]") {
  std::mt19937 random(41);
  for (const Gripper& gripper : hands()) {
    for (int n = 0; n < 200; ++n) {
      const Eigen::Isometry3d X_CG = random_pose(random);
      const double opening = uniform(random, gripper.min_opening, gripper.max_opening);
      const double width = uniform(random, gripper.min_opening, opening);
      const auto common = common_fingers(gripper, X_CG, opening, width);
      const double preshape = uniform(random, opening, gripper.max_opening);
      const SweptHand hand = sweep_hand(gripper, X_CG, preshape, width, kApproach);
      for (int k = 0; k < 20; ++k) {
        for (std::size_t i = 0; i < 2; ++i) {
          const Eigen::Vector3d p = random_in(random, common[i]);
          REQUIRE((hand.fingers[i].inflated(1e-9).contains(p) ||
                   hand.closing[i].inflated(1e-9).contains(p)));
        }
      }
    }
  }
}

TEST_CASE("what palms have in common lies in the palm of each hand, at each width", "[hand]") {
  std::mt19937 random(37);
  int common = 0;
  for (const Gripper& gripper : hands()) {
    for (int n = 0; n < 200; ++n) {
      const Eigen::Isometry3d X_CG = random_pose(random);
      const Eigen::Vector3d some =
          random_point(random, {Eigen::Vector3d::Constant(-0.02), Eigen::Vector3d::Constant(0.02)});
      const Eigen::AlignedBox3d places_G(some.cwiseMin(0.0), some.cwiseMax(0.0));
      const auto palm = common_palm(gripper, X_CG, places_G, kApproach);
      if (!palm) continue;
      ++common;
      for (int k = 0; k < 20; ++k) {
        const Eigen::Isometry3d X = X_CG * Eigen::Translation3d(random_point(random, places_G));
        const double width = uniform(random, gripper.min_opening, gripper.max_opening);
        const SweptHand hand = sweep_hand(gripper, X, gripper.max_opening, width, kApproach);
        CHECK(hand.palm.inflated(1e-9).contains(random_in(random, *palm)));
      }
    }
  }
  CHECK(common > 300);
}
