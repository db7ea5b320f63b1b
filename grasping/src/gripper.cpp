#include "quadrille/grasping/gripper.hpp"

#include <cmath>
#include <stdexcept>

namespace quadrille {

namespace {

void demand(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("gripper: " + what);
}

bool positive(double x) { return std::isfinite(x) && x > 0.0; }

}  // namespace

void Gripper::check() const {
  demand(positive(max_opening), "max_opening must be positive");
  demand(min_opening >= 0.0 && min_opening < max_opening,
         "min_opening must lie between 0 and max_opening");
  for (int i = 0; i < 3; ++i) {
    demand(positive(finger[i]), "finger must have positive sizes");
    demand(positive(palm[i]), "palm must have positive sizes");
  }
  demand(positive(pad.x()) && pad.x() <= finger.x(), "pad must be no wider than finger along x");
  demand(positive(pad.y()) && pad.y() <= finger.z(), "pad must be no longer than finger along z");
  demand(finger_front >= 0.0 && finger_front < finger.z(),
         "finger_front must lie between 0 and the length of finger");
  demand(positive(max_force), "max_force must be positive");
}

Gripper franka_hand() {
  Gripper hand;
  hand.name = "franka";
  hand.max_opening = 0.08;
  // Tip 17.5 x 15.2 mm; the tool centre point lies 45 mm before the palm and 9 mm behind the tips.
  hand.finger = {0.0175, 0.0152, 0.054};
  hand.finger_front = 0.009;
  hand.pad = {0.0175, 0.018};
  hand.palm = {0.063, 0.204, 0.066};
  hand.max_force = 70.0;
  return hand;
}

Gripper schunk_wsg50() {
  Gripper hand;
  hand.name = "wsg50";
  hand.max_opening = 0.11;
  hand.finger = {0.02, 0.016, 0.075};
  hand.finger_front = 0.01;
  hand.pad = {0.02, 0.02};
  hand.palm = {0.0495, 0.146, 0.0725};
  hand.max_force = 80.0;
  return hand;
}

Gripper gripper_by_name(const std::string& name) {
  if (name == "franka") return franka_hand();
  if (name == "wsg50") return schunk_wsg50();
  throw std::invalid_argument("unknown gripper '" + name + "'; known: franka, wsg50");
}

}  // namespace quadrille
