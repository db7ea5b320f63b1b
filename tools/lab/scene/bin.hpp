#pragma once

#include "lab/scene/layout.hpp"

namespace quadrille::scene {

/// A tray full of equal cylinders on a table.
struct BinOptions {
  int cylinders = 20;
  /// Of each cylinder [m].
  double radius = 0.018, length = 0.09;
  /// Half the inner edges of the tray and the height of its walls [m].
  double half_x = 0.15, half_y = 0.12, wall = 0.05;
  /// Height of the camera over the table [m].
  double height = 0.7;
};

/// Cylinders lying and leaning on each other in a tray, and a camera above that looks at its
/// middle.
///
/// One after the other is let fall in several random poses, and stays in the lowest. It stops
/// where the ball-ended cylinders about two of them touch, so that none is within another. What
/// finds no place is left out.
/// @throws std::invalid_argument if a cylinder has no room in the tray
Layout fill_bin(const BinOptions& options, Random* random);

}  // namespace quadrille::scene
