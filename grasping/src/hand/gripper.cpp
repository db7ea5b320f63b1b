#include "quadrille/grasping/gripper.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace quadrille {
namespace {

// No hand is larger than this; a larger number was probably meant in millimetres [m].
constexpr double kMaxSize = 1.0;
// Tolerance for rounding between sizes that are meant to be equal [m].
constexpr double kRounding = 1e-9;

void demand(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("gripper: " + what);
}

void demand_size(const char* field, double x) {
  demand(std::isfinite(x) && x > 0.0,
         std::string(field) + " must be positive; measure it on the hand");
  demand(x <= kMaxSize,
         std::string(field) + " is more than 1 m; give sizes in metres, not millimetres");
}

template <class Sizes>
void demand_sizes(const char* field, const Sizes& sizes) {
  for (const double size : sizes) demand_size(field, size);
}

/// Returns the sine of the links' angle at an opening.
double swing(const Gripper& hand, double opening) {
  return std::sin(hand.link_angle) - (hand.max_opening - opening) / (2.0 * hand.link_length);
}

void check_openings(const Gripper& hand) {
  demand_size("max_opening", hand.max_opening);
  demand(std::isfinite(hand.min_opening) && hand.min_opening >= 0.0,
         "min_opening must be a number and not negative; 0 is closed");
  demand(hand.min_opening < hand.max_opening,
         "min_opening must be smaller than max_opening; are the two swapped?");
}

void check_finger(const Gripper& hand) {
  demand_sizes("finger", hand.finger);
  demand_sizes("pad", hand.pad);
  demand(hand.pad.x() <= hand.finger.x() + kRounding,
         "pad is wider than finger along x; make pad[0] at most finger[0]");
  demand(hand.pad.y() <= hand.finger.z() + kRounding,
         "pad is longer than finger along z; make pad[1] at most finger[2]");
  demand(hand.finger_front >= 0.0 && hand.finger_front < hand.finger.z(),
         "finger_front must lie between 0 and the length of finger, finger[2]");
  demand(0.5 * hand.pad.y() <= hand.finger_front + kRounding,
         "pad reaches beyond the tip; make finger_front at least half of pad[1]");
  demand(0.5 * hand.pad.y() <= hand.finger.z() - hand.finger_front + kRounding,
         "pad reaches into the palm; make finger[2] at least finger_front plus half of pad[1]");
}

void check_links(const Gripper& hand) {
  demand(hand.link_length >= 0.0 && hand.link_length <= kMaxSize,
         "link_length must lie in 0 to 1 m; 0 is for fingers that slide straight");
  demand(hand.link_angle >= 0.0 && hand.link_angle < 1.5,
         "link_angle must lie in 0 to 1.5 rad; give radians, not degrees");
  demand(hand.link_length > 0.0 || hand.link_angle == 0.0,
         "link_length is missing beside link_angle; give both or neither");
  demand(hand.link_angle > 0.0 || hand.link_length == 0.0,
         "link_angle is missing beside link_length; give both or neither");
  demand(hand.link_length == 0.0 || swing(hand, hand.min_opening) > -1.0,
         "link_length is too short to close to min_opening; make it longer");
}

}  // namespace

void Gripper::check() const {
  check_openings(*this);
  check_finger(*this);
  demand_sizes("palm", palm);
  demand(std::isfinite(max_force) && max_force > 0.0,
         "max_force must be positive; give the closing force in newtons");
  check_links(*this);
  demand(tcp == 0.0 || tcp >= finger.z() - finger_front - kRounding,
         "finger reaches farther back than tcp; make tcp at least finger[2] - finger_front");
  demand(tcp <= kMaxSize, "tcp is more than 1 m; give sizes in metres, not millimetres");
}

double Gripper::extension(double opening) const {
  if (link_length == 0.0) return 0.0;
  const double s =
      std::clamp(swing(*this, std::clamp(opening, min_opening, max_opening)), -1.0, 1.0);
  return link_length * (std::sqrt(1.0 - s * s) - std::cos(link_angle));
}

double Gripper::max_extension(double narrow, double wide) const {
  if (link_length == 0.0) return 0.0;
  // The tips reach farthest where the links lie along the approach.
  const double straight = max_opening - 2.0 * link_length * std::sin(link_angle);
  return extension(std::clamp(straight, std::min(narrow, wide), std::max(narrow, wide)));
}

double Gripper::reach(double width) const { return finger.z() - finger_front + extension(width); }

}  // namespace quadrille
