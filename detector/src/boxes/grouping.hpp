#pragma once

#include <vector>

#include "boxes/face.hpp"

namespace quadrille {

/// True if two faces are at right angles, as far as their normals are known.
bool at_right_angles(const Face& a, const Face& b);

/// True if two faces at right angles meet in an edge of a solid: each ends at the other's plane,
/// behind it, and they lie side by side along the edge.
bool share_edge(const Face& a, const Face& b);

/// Faces that may belong together, as indices: threes of which each two share an edge, then twos,
/// those with the most points first. A face may be in several groups.
std::vector<std::vector<int>> group_faces(const std::vector<Face>& faces);

}  // namespace quadrille
