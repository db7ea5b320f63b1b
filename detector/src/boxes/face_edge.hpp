#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"
#include "boxes/mixed_edge.hpp"
#include "boxes/seen_through_plane.hpp"

namespace quadrille {

/// Projects points of the cloud along their lines of sight onto a face's plane.
std::vector<SeenThrough> look_through(const Face& face,
                                      const std::vector<Eigen::Vector3d>& points_C,
                                      const DirectionIndex& sight);

/// The end of a face on one side.
struct FaceEdge {
  /// Distance from the origin of C along the direction of the side, and its standard deviation [m].
  double at = 0.0, std = 0.0;
  /// True if the sensor saw the face end there: what it saw beside the edge lies behind the face or
  /// touches it. False if something in front hides the rest or the image ends; the face then
  /// reaches at least to `at`.
  bool seen = false;
  /// True if another surface leaves the face here, so that `at` is where the two would meet if the
  /// edge were sharp.
  bool meets = false;
  /// Pixels that the sensor mixed here; `at` takes no account of them.
  MixedPixels mixed = {};
};

/// Finds the edge of a face from the last points of rows that run towards it. The edge is their
/// median plus half a pitch, since it lies between the last point and the next.
/// @param out_C   unit direction within the plane from the face towards the edge
/// @param around  what was seen through the face's plane, on the face and around it
FaceEdge edge_of(const Face& face, const Eigen::Vector3d& out_C,
                 const std::vector<SeenThrough>& around, const DirectionIndex& sight);

/// How much of a part of a face was seen to be there.
struct Filling {
  /// Points on the plane and points behind it; points in front of it do not count.
  int on = 0, through = 0;

  /// Share of these points that lie on the plane; a disc fills 0.79 of the square around it.
  /// Returns 1 without any points.
  double share() const;
  Filling& operator+=(const Filling& other);
};

/// Counts what was seen through a rectangle in the face's plane.
/// @param low, high  bounds of the rectangle along unit directions u and v in the plane [m]
Filling filling_of(const Face& face, const Eigen::Matrix<double, 3, 2>& uv_C,
                   const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                   const std::vector<SeenThrough>& around);

}  // namespace quadrille
