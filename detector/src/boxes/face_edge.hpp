#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"

namespace quadrille {

/// What was seen in the direction of a place in a face's plane.
struct SeenThrough {
  /// The point that was seen, where its line of sight meets the plane, and its height over the
  /// plane, positive on the side of the eye [m].
  Eigen::Vector3d p_C, on_C;
  double height = 0.0;
};

/// Points of the cloud as seen through a face's plane.
std::vector<SeenThrough> look_through(const Face& face,
                                      const std::vector<Eigen::Vector3d>& points_C,
                                      const DirectionIndex& sight);

/// Where a face ends on one side.
struct FaceEdge {
  /// Distance from the origin of C along the direction of the side, and its standard deviation [m].
  double at = 0.0, std = 0.0;
  /// True if the sensor saw that the face ends there: what it sees beside it lies behind the face,
  /// or touches it. False where something before the face hides the rest, or the image ends; the
  /// face then reaches to `at` at least.
  bool seen = false;
};

/// Finds the edge of a face from the last points of rows that run towards it: their median, half a
/// pitch farther on, for the edge lies between the last point and the next one.
/// @param out_C   unit direction in the plane that the edge lies to
/// @param around  what was seen through the face's plane towards the face and around it
FaceEdge edge_of(const Face& face, const Eigen::Vector3d& out_C,
                 const std::vector<SeenThrough>& around, const DirectionIndex& sight);

/// How much of a part of a face was seen to be there.
struct Filling {
  /// Points on the plane, and points behind it; what lies before it does not count.
  int on = 0, through = 0;

  /// Share of them on the plane: a disc fills 0.79 of the square around it. 1 of so few that they
  /// tell nothing.
  double share() const;
  Filling& operator+=(const Filling& other);
};

/// What was seen through a rectangle in the face's plane.
/// @param low, high  of the rectangle along unit directions u and v in the plane [m]
Filling filling_of(const Face& face, const Eigen::Matrix<double, 3, 2>& uv_C,
                   const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                   const std::vector<SeenThrough>& around);

}  // namespace quadrille
