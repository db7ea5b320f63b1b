#pragma once

#include <Eigen/Core>

#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"
#include "boxes/face_edge.hpp"

namespace quadrille {

/// The edge of a face that ends a side of a box.
struct Outline {
  const Face* face = nullptr;
  /// The end of the box: its axis, and 0 for the lower or 1 for the upper end.
  int axis = 0, upper = 0;
  /// Unit outward direction of the end.
  Eigen::Vector3d out_C = Eigen::Vector3d::UnitX();
  FaceEdge edge;

  /// Angle by which a rounded edge has turned away from the face where the line of sight touches it
  /// [rad].
  double turn(const Eigen::Vector3d& eye_C) const;
  /// How far a box with rounded edges reaches beyond this outline [m]. The edge seems to end where
  /// it leaves the tolerance δ of the face, √(δ(2r − δ)) beyond the beginning of the rounding, or
  /// where it turns away from the sensor, r sin(turn) beyond it.
  double hidden(double radius, const DirectionIndex& sight) const;
};

}  // namespace quadrille
