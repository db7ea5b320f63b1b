#include "quadrille/grasping/gripper.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "hand/hand.hpp"
#include "lcmtypes/contains.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using test::contains;

TEST_CASE("each known gripper is consistent, and is found by its name", "[gripper]") {
  for (const Gripper& made : {franka_hand(), schunk_wsg50(), robotiq_2f85(), robotiq_2f140()}) {
    CHECK_NOTHROW(made.check());
    CHECK(gripper_by_name(made.name).max_opening == made.max_opening);
  }
  CHECK_THROWS_WITH(gripper_by_name("claw"), contains("franka") && contains("wsg50"));
}

TEST_CASE("a contradiction in a gripper is named by its field, with the remedy", "[gripper]") {
  using Spoil = void (*)(Gripper&);
  const std::pair<Spoil, const char*> spoiled[] = {
      {[](Gripper& g) { g.max_opening = 0.0; }, "max_opening must be positive; "},
      {[](Gripper& g) { g.max_opening = 80.0; }, "max_opening is more than 1 m; "},
      {[](Gripper& g) { g.min_opening = -0.01; }, "min_opening must be a number and not neg"},
      {[](Gripper& g) { g.min_opening = std::nan(""); }, "min_opening must be"},
      {[](Gripper& g) { g.min_opening = 0.09; }, "min_opening must be smaller than"},
      {[](Gripper& g) { g.finger.y() = -1.0; }, "finger must be positive; "},
      {[](Gripper& g) { g.pad.x() = 0.02; }, "pad is wider than finger"},
      {[](Gripper& g) { g.pad.y() = 0.06; }, "pad is longer than finger"},
      {[](Gripper& g) { g.pad.y() = 0.02; }, "pad reaches beyond the tip; "},
      {[](Gripper& g) { g.finger_front = 0.04, g.pad.y() = 0.03; }, "pad reaches into the palm; "},
      {[](Gripper& g) { g.finger_front = 0.2; }, "finger_front must lie between"},
      {[](Gripper& g) { g.palm.z() = std::nan(""); }, "palm must be positive; "},
      {[](Gripper& g) { g.max_force = 0.0; }, "max_force must be positive; "},
      {[](Gripper& g) { g.tcp = 0.03; }, "finger reaches farther back than tcp; "},
      {[](Gripper& g) { g.tcp = 103.4; }, "tcp is more than 1 m; "},
      {[](Gripper& g) { g.link_length = -0.1; }, "link_length must lie in"},
      {[](Gripper& g) { g.link_angle = 41.0; }, "give radians, not degrees"},
      {[](Gripper& g) { g.link_angle = 0.7; }, "link_length is missing beside"},
      {[](Gripper& g) { g.link_length = 0.07; }, "link_angle is missing beside"},
      {[](Gripper& g) { g.link_length = 0.02, g.link_angle = 0.7; },
       "link_length is too short to close"}};
  for (const auto& [spoil, part] : spoiled) {
    Gripper hand = franka_hand();
    spoil(hand);
    CHECK_THROWS_WITH(hand.check(), Catch::Matchers::StartsWith("gripper: ") && contains(part) &&
                                        !contains("\n"));
  }
}

TEST_CASE("fingers on links reach forward along a circle as they close", "[gripper]") {
  Gripper hand = franka_hand();
  CHECK(hand.extension(0.0) == 0.0);
  // From 45° to straight ahead: half the opening is L sin 45°, the shift L (1 − cos 45°).
  hand.link_length = 0.05;
  hand.link_angle = 0.25 * std::numbers::pi;
  hand.max_opening = 2.0 * 0.05 * std::sqrt(0.5);
  hand.check();
  CHECK(hand.extension(hand.max_opening) == Approx(0.0).margin(1e-12));
  CHECK(hand.extension(0.0) == Approx(0.05 * (1.0 - std::sqrt(0.5))));
  CHECK(hand.reach(0.0) == Approx(0.045 + hand.extension(0.0)));
  CHECK(hand.max_extension(0.02, 0.06) == Approx(hand.extension(0.02)));
  // With steeper links the tips pass the farthest point and draw back again.
  hand.link_angle = 0.6;
  CHECK(hand.max_extension(0.0, hand.max_opening) == Approx(0.05 * (1.0 - std::cos(0.6))));
  CHECK(hand.max_extension(0.0, hand.max_opening) > hand.extension(0.0));
}

TEST_CASE("the swept hand of fingers on links holds the pads at every opening", "[gripper]") {
  Gripper hand = franka_hand();
  hand.link_length = 0.05;
  hand.link_angle = 0.6;
  const double preshape = 0.08, width = 0.01;
  const SweptHand swept = sweep_hand(hand, Eigen::Isometry3d::Identity(), preshape, width, 0.05);
  for (double opening = width; opening <= preshape; opening += 0.002) {
    // Where the pads' middle is, in the frame of the closed hand.
    const double z = hand.extension(opening) - hand.extension(width);
    const double tip = z + hand.finger_front - 1e-6;
    CAPTURE(opening);
    CHECK(swept.closing[0].contains({0.0, 0.5 * opening, tip}));
  }
  // The palm stands back by the extension of the closed hand.
  const double front = -hand.reach(width);
  CHECK(swept.palm.contains({0.0, 0.0, front - 1e-6}));
  CHECK_FALSE(swept.palm.contains({0.0, 0.0, front + 1e-6}));
}

TEST_CASE("the swept hand covers fingers, palm and closing where the frame says", "[gripper]") {
  const SweptHand hand = sweep_hand(franka_hand(), Eigen::Isometry3d::Identity(), 0.06, 0.04, 0.05);
  CHECK(hand.fingers[0].contains({0.0, 0.031, 0.0089}));
  CHECK(hand.fingers[1].contains({0.0, -0.045, -0.094}));
  CHECK_FALSE(hand.fingers[0].contains({0.0, 0.031, 0.0091}));
  CHECK_FALSE(hand.fingers[0].contains({0.0, 0.029, 0.0}));
  CHECK(hand.palm.contains({0.03, 0.1, -0.046}));
  CHECK(hand.palm.contains({0.03, 0.1, -0.045 - 0.066 - 0.049}));
  CHECK_FALSE(hand.palm.contains({0.0, 0.0, -0.044}));
  CHECK(hand.closing[1].contains({0.0, -0.025, 0.0}));
  CHECK_FALSE(hand.closing[1].contains({0.0, -0.019, 0.0}));
}
