#pragma once

#include "boxes/edge_rows.hpp"

namespace quadrille {

/// Counts the rows of points of a face that show mixed pixels at an outline: pixels whose depth the
/// sensor took partly from the face and partly from the background.
///
/// Mixed pixels float between the face and what was seen behind it, and lie on neither, so that the
/// face seems to end early. Their heights change from one surface to the other, and the outline
/// lies where they cross half of the gap.
struct MixedPixels {
  /// Rows behind whose end one surface was seen, far enough from the face to tell; and those of
  /// them with points that float between the two.
  int rows = 0, mixed = 0;
  /// How far beyond the ends of the rows the outline lies if the pixels are mixed, and the standard
  /// deviation of that [m].
  double reach = 0.0, std = 0.0;
};

/// Looks for mixed pixels beside the rows of a face.
/// @param tolerance  of the face [m]
/// @param pitch      distance between neighbouring points along the rows [m]
MixedPixels mixed_pixels(const Rows& rows, double tolerance, double pitch);

}  // namespace quadrille
