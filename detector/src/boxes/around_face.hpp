#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "boxes/box_draft.hpp"

namespace quadrille {

/// One of the four edges of the face of a draft that has no other face.
struct LoneEdge {
  /// The end of the box on this side: its axis, 1 or 2, and 0 for the lower or 1 for the upper end.
  int axis = 1, upper = 0;
  /// Distance of the edge from the origin of C in the end's outward direction [m].
  double at = 0.0;
};

/// The points right beside an edge show how the face ends there.
struct BesideEdge {
  /// True if the side of the box that begins at the edge is turned to the sensor.
  bool faces_eye = false;
  /// True if most of what was seen there lies behind the face.
  bool free = false;
  /// True if the face goes on beyond the edge and bends away too slowly for the edge of a box.
  bool goes_on = false;
  /// How far outward of the edge the side lies that begins there, and the spread of its points [m];
  /// nullopt if too few of its points were seen. It is positive if the edge is rounded, and
  /// negative if the sensor widens outlines.
  std::optional<double> side;
  double spread = 0.0;
};

/// The lines of sight past an edge show how deep the box behind the face is.
struct DepthPastEdge {
  /// Depth at which most of the lines along the edge pass behind the box: it is no deeper, up to
  /// what the rounding of its farther edge lets pass [m].
  double bound = 0.0;
  /// How far the bound may be off, since the lines are a pixel apart [m].
  double unsure = 0.0;
  /// Depth to which points were seen on the side that begins at the edge [m]; 0 if there are none.
  double seen = 0.0;
};

/// Examines a single view around and behind the face of a draft that has no other face.
class AroundFace {
 public:
  /// @param edges  the edges at the lower and upper ends of axes 1 and 2, at axis − 1
  AroundFace(const BoxDraft& draft, const std::array<std::array<double, 2>, 2>& edges);

  BesideEdge beside(const LoneEdge& edge) const;
  /// Nullopt if the side that begins at the edge is turned away from the sensor, or if nothing was
  /// seen past most of the edge.
  /// @param edge  where the side lies
  std::optional<DepthPastEdge> depth_past(const LoneEdge& edge) const;
  /// How far the normal turns across the face [rad].
  double turn() const;

 private:
  /// A point, its place on the plane of the face along its line of sight, in frame A, and its depth
  /// behind the plane [m].
  struct Point {
    Eigen::Vector3d p_A, on_A;
    double depth = 0.0;
  };

  /// Returns the position of a place along an edge. It runs from 0 to 1 over the part of the edge
  /// that is looked at.
  double along(const LoneEdge& edge, const Eigen::Vector3d& place_A) const;
  bool is_turned_to_eye(const LoneEdge& edge) const;

  const BoxDraft& draft_;
  const Face& face_;
  std::array<std::array<double, 2>, 2> edges_;
  Eigen::Vector3d eye_A_;
  std::vector<Point> points_;
};

}  // namespace quadrille
