#pragma once

#include <vector>

#include "contacts/contact_line.hpp"
#include "quadrille/detector/box.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// Contact lines across the pairs of parallel faces of a box.
struct BoxLines {
  /// Over a grid on each pair of faces, and near their borders, where a hand reaches that cannot
  /// span the box. A face that was not seen is taken at its bound: the hand opens as far as the box
  /// may reach.
  std::vector<ContactLine> lines;
  /// Pairs of faces whose distance is not known well enough to close on.
  int unmeasured = 0;
};
BoxLines box_lines(const Box& box, const Gripper& gripper);

}  // namespace quadrille
