#pragma once

#include "lab/scene/layout.hpp"

namespace quadrille::scene {

/// A tray full of equal cylinders on a table.
struct BinOptions {
  int cylinders = 20;
  /// Size of each cylinder [m].
  double radius = 0.018, length = 0.09;
  /// Half the lengths of the tray's inner edges, and the height of its walls [m].
  double half_x = 0.15, half_y = 0.12, wall = 0.05;
  /// Height of the camera over the table [m].
  double height = 0.7;
};

/// Makes cylinders that lie and lean on each other in a tray, and a camera above that looks at its
/// middle.
///
/// The cylinders fall one after the other. Each falls in several random poses and stays in the
/// lowest. It stops where two cylinders with rounded ends around them touch, so that none
/// penetrates another. A cylinder that finds no place is left out.
/// @throws std::invalid_argument if a cylinder does not fit into the tray
Layout fill_bin(const BinOptions& options, Random* random);

}  // namespace quadrille::scene
