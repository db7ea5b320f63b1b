#pragma once

#include <vector>

#include "contacts/contact_line.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// Contact lines across the pairs of parallel faces of a box.
struct BoxLines {
  /// The lines lie on a grid on each pair of faces, and near the borders, which a hand can reach
  /// even if it cannot span the box. A face that was not seen is taken at its outer bound, so that
  /// the hand opens far enough for any possible size. No contact lies where the box only is guessed
  /// to be.
  std::vector<ContactLine> lines;
  /// Number of pairs of faces whose distance is not known well enough to close on.
  int unmeasured = 0;
};
BoxLines box_lines(const Box& box, const Gripper& gripper);

}  // namespace quadrille
