#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "base/vector_clones.hpp"

namespace quadrille {

/// An affine map as plain numbers, which a loop over many points keeps in registers.
struct AffineRows {
  float X[3][4];

  explicit AffineRows(const Eigen::Affine3f& map) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 4; ++c) X[r][c] = map(r, c);
    }
  }

  /// Coordinate r of the image of a point.
  QUADRILLE_INTO_CLONES float of_point(int r, float x, float y, float z) const {
    return X[r][0] * x + X[r][1] * y + X[r][2] * z + X[r][3];
  }
  /// Coordinate r of the image of a direction.
  QUADRILLE_INTO_CLONES float of_direction(int r, float x, float y, float z) const {
    return X[r][0] * x + X[r][1] * y + X[r][2] * z;
  }
};

/// A box in its frame and the map to it.
struct BoxTest {
  AffineRows rows;
  float low[3], high[3];

  /// @param X_BC  map from frame C to the frame of the box, which may scale
  /// @param slack  by how much the box is widened, as a share of the coordinates
  BoxTest(const Eigen::Affine3f& X_BC, const Eigen::AlignedBox3f& box_B, float slack = 0.0f)
      : rows(X_BC) {
    for (int r = 0; r < 3; ++r) {
      const float most = std::abs(X_BC(r, 3)) + std::abs(box_B.min()[r]) + std::abs(box_B.max()[r]);
      low[r] = box_B.min()[r] - slack * most;
      high[r] = box_B.max()[r] + slack * most;
    }
  }

  /// One if a point of frame C lies in the box, else zero, without a branch.
  QUADRILLE_INTO_CLONES int holds(float x, float y, float z) const {
    int inside = 1;
    for (int r = 0; r < 3; ++r) {
      const float c = rows.of_point(r, x, y, z);
      inside &= (c >= low[r]) & (c <= high[r]);
    }
    return inside;
  }
};

}  // namespace quadrille
