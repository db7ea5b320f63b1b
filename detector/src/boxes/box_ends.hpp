#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <vector>

#include "boxes/box_draft.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// No side of a box is longer [m], whereas tables, walls and floors are.
inline constexpr double kMaxSide = 0.7;
/// If the distance of two ends is uncertain by more than this share of it, the faces belong to
/// several things, to a curved or thin one, or to a step that noise feigns.
inline constexpr double kMaxDoubt = 0.1;

/// One end of one side of a box.
struct BoxEnd {
  /// Position along the outward direction, from the origin of C, and its standard deviation [m].
  double at = 0.0, std = 0.0;
  /// True if the side was seen to end there.
  bool seen = false;
  /// How far beyond `at` the side reaches at most, and most likely [m].
  double may_reach = 0.0, likely = 0.0;
  /// How far `at` lies beyond what was seen of the side, where its rounded edge is turned away [m].
  double hidden = 0.0;
  /// True if the end lies on a plane that is parallel to it.
  bool rests = false;
};

/// The lower and the upper end of each side.
using BoxEnds = std::array<std::array<BoxEnd, 2>, 3>;

/// The ends of a box as far as they were seen, and the radius of its edges [m], 0 if these are
/// sharp.
struct SeenEnds {
  BoxEnds ends;
  double radius = 0.0;
};

/// Finds the ends as far as they were seen, from the faces, their outlines, and the planes on which
/// the outlines rest.
/// @param planes  all detected planes except the faces
SeenEnds find_ends(const BoxDraft& draft, const std::vector<const Detection*>& planes);

/// Moves an end onto a parallel plane next to it. The outline of a face alone cannot tell the face
/// from the plane that it touches.
/// @param within  the most by which the end may move [m]
BoxEnd rested(const BoxDraft& draft, const std::vector<const Detection*>& planes, BoxEnd end,
              int axis, int upper, double within);

/// Bounds the unseen ends: they may neither hide points that were seen nor cross a plane. Seen ends
/// that may reach farther reach no farther than that either.
BoxEnds bounded(const BoxDraft& draft, const std::vector<const Detection*>& planes, BoxEnds ends);

/// The box between the positions of the ends, in frame A [m].
Eigen::AlignedBox3d seen_part(const BoxEnds& ends);

/// Standard deviation of what may lie anywhere in a range of this width.
inline double uniform_std(double width) { return width / std::sqrt(12.0); }

}  // namespace quadrille
