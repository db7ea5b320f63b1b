#include "quadrille/grasping/gripper.hpp"

#include <cmath>
#include <stdexcept>

#include "quadrille/grasping/hand.hpp"
#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("the Franka Hand is known by name and consistent", "[gripper]") {
  const Gripper hand = gripper_by_name("franka");
  CHECK_NOTHROW(hand.check());
  CHECK(hand.max_opening == Approx(0.08));
}

TEST_CASE("the WSG 50 is known by name, consistent and opens wider", "[gripper]") {
  const Gripper hand = gripper_by_name("wsg50");
  CHECK_NOTHROW(hand.check());
  CHECK(hand.name == "wsg50");
  CHECK(hand.max_opening == Approx(0.11));
}

TEST_CASE("an unknown gripper's message lists the known ones", "[gripper]") {
  try {
    gripper_by_name("claw");
    FAIL("no exception");
  } catch (const std::invalid_argument& error) {
    CHECK(std::string(error.what()).find("franka") != std::string::npos);
    CHECK(std::string(error.what()).find("wsg50") != std::string::npos);
  }
}

TEST_CASE("a contradiction in a gripper is named by its field", "[gripper]") {
  const auto message = [](auto&& spoil) {
    Gripper hand = franka_hand();
    spoil(hand);
    try {
      hand.check();
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto names = [](const std::string& text, const char* field) {
    return text.find(field) != std::string::npos;
  };
  CHECK(names(message([](Gripper& g) { g.max_opening = 0.0; }), "max_opening"));
  CHECK(names(message([](Gripper& g) { g.min_opening = 0.09; }), "min_opening"));
  CHECK(names(message([](Gripper& g) { g.finger.y() = -1.0; }), "finger"));
  CHECK(names(message([](Gripper& g) { g.pad.x() = 0.1; }), "pad"));
  CHECK(names(message([](Gripper& g) { g.finger_front = 0.2; }), "finger_front"));
  CHECK(names(message([](Gripper& g) { g.palm.z() = std::nan(""); }), "palm"));
  CHECK(names(message([](Gripper& g) { g.max_force = 0.0; }), "max_force"));
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
