// The grippers that the library knows by name; tools/grippers has the same ones as files.
#include <stdexcept>

#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

Gripper franka_hand() {
  Gripper hand;
  hand.name = "franka";
  hand.max_opening = 0.08;
  // The tip is 17.5 x 15.2 mm; the tool centre point lies 45 mm in front of the palm and 9 mm
  // behind the tips.
  hand.finger = {0.0175, 0.0152, 0.054};
  hand.finger_front = 0.009;
  hand.pad = {0.0175, 0.018};
  hand.palm = {0.063, 0.204, 0.066};
  hand.max_force = 70.0;
  // Distance from panda_hand to panda_hand_tcp.
  hand.tcp = 0.1034;
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
  // Distance from the middle of the body, where Drake has the hand's frame.
  hand.tcp = 0.5 * 0.0725 + 0.065;
  return hand;
}

// The Robotiqs' sizes come from the joint origins and the pads of ROS-Industrial's descriptions.
// Their fingers swing on links, and the swept hand follows the tips.
Gripper robotiq_2f85() {
  Gripper hand;
  hand.name = "robotiq_2f85";
  // This is Robotiq's figure; the pads of the description leave 0.0860.
  hand.max_opening = 0.085;
  hand.finger = {0.022, 0.0252, 0.0512};
  hand.finger_front = 0.01875;
  hand.pad = {0.022, 0.0375};
  hand.palm = {0.075, 0.16, 0.0979};
  hand.max_force = 235.0;
  hand.link_length = 0.05712;
  hand.link_angle = 0.7185;
  // Distance from robotiq_arg2f_base_link to the middle of the open pads.
  hand.tcp = 0.1303;
  return hand;
}

Gripper robotiq_2f140() {
  Gripper hand;
  hand.name = "robotiq_2f140";
  // Distance between the description's pads; Robotiq's figure of 0.14 is without pads.
  hand.max_opening = 0.1285;
  hand.finger = {0.03, 0.031, 0.0808};
  hand.finger_front = 0.035;
  hand.pad = {0.03, 0.07};
  hand.palm = {0.075, 0.21, 0.1312};
  hand.max_force = 125.0;
  hand.link_length = 0.1;
  hand.link_angle = 0.7024;
  hand.tcp = 0.177;
  return hand;
}

std::vector<Gripper> built_in_grippers() {
  return {franka_hand(), robotiq_2f140(), robotiq_2f85(), schunk_wsg50()};
}

Gripper gripper_by_name(const std::string& name) {
  std::string known;
  for (const Gripper& hand : built_in_grippers()) {
    if (hand.name == name) return hand;
    known += (known.empty() ? "" : ", ") + hand.name;
  }
  throw std::invalid_argument("unknown gripper '" + name + "'; known: " + known);
}

}  // namespace quadrille
