#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxes/edge_rows.hpp"
#include "boxes/face.hpp"
#include "boxes/seen_through_plane.hpp"

namespace quadrille {

/// The part of a rounded edge that turns away from a face and was still seen.
struct TurningEdge {
  /// How far it leads beyond the end of the face in the direction of the edge, and how far below
  /// the face [m]; 0 if the face just ends.
  double beyond = 0.0, drop = 0.0;
};

/// Follows the surface beyond the ends of a face's rows from point to neighbouring point below the
/// face, up to the first gap. The result is the farthest place that a row reached, in the median of
/// the rows that saw their end.
/// @param out_C   unit direction within the plane from the face towards the edge
/// @param around  what was seen through the face's plane, on the face and around it
TurningEdge turning_edge(const Face& face, const Eigen::Vector3d& out_C,
                         const std::vector<SeenThrough>& around, Rows& rows);

}  // namespace quadrille
