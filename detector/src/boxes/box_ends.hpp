#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "boxes/box_draft.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// No side of a box is longer [m]: tables, walls and floors are.
inline constexpr double kMaxSide = 0.7;

/// One end of one side of a box.
struct BoxEnd {
  /// Along the outward direction from the origin of C, and its standard deviation [m].
  double at = 0.0, std = 0.0;
  /// True if it was seen to end there.
  bool seen = false;
  /// How far beyond `at` it may reach at most, and most likely reaches [m].
  double may_reach = 0.0, likely = 0.0;
  /// True if it lies on a plane that is parallel to it.
  bool rests = false;
};

/// The lower and the upper end of each side.
using BoxEnds = std::array<std::array<BoxEnd, 2>, 3>;

/// The ends as far as they were seen: faces, outlines of faces, and planes that these rest on.
/// @param planes  all planes that were detected but the faces
BoxEnds find_ends(const BoxDraft& draft, const std::vector<const Detection*>& planes);

/// Bounds the ends that were not seen by what they would hide, and by the planes they would cross.
void bound_open_ends(const BoxDraft& draft, const std::vector<const Detection*>& planes,
                     BoxEnds* ends);

/// What lies between the ends as far as they were seen, in frame A [m].
Eigen::AlignedBox3d seen_part(const BoxEnds& ends);

}  // namespace quadrille
