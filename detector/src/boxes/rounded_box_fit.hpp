#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxes/box_draft.hpp"
#include "boxes/box_ends.hpp"
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

/// Fits the ends of a box that are outlines, together with the radius of its edges. The residuals
/// are the distances of the points about its edges from the rounded box, with Tukey's weights, and
/// the distances of the ends from the outlines. Other ends stay as they are.
/// @param outlines  those that were seen
/// @param ends      each outline's end where the outline was seen; replaced by the fit
/// @return the radius [m], 0 for sharp edges
double fit_rounded_box(const BoxDraft& draft, const std::vector<Outline>& outlines, BoxEnds* ends);

}  // namespace quadrille
