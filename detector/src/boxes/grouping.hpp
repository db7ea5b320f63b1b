#pragma once

#include <vector>

#include "boxes/face.hpp"

namespace quadrille {

/// True if two faces are at right angles.
bool at_right_angles(const Face& a, const Face& b);

/// True if two faces at right angles meet in a convex edge of a solid: each ends at the other's
/// plane and lies behind it.
bool share_edge(const Face& a, const Face& b);

/// Groups of faces, as indices, that may belong to one box: first triples whose faces all share
/// edges pairwise, then pairs, each with the most points first. A face may be in several groups.
std::vector<std::vector<int>> group_faces(const std::vector<Face>& faces);

}  // namespace quadrille
