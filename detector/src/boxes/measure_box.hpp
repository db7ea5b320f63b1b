#pragma once

#include <optional>
#include <vector>

#include "boxes/box_ends.hpp"
#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// True if what was seen of a face fills the rectangle around it including the corners, which no
/// disc does.
bool is_rectangular(const Face& face, const DirectionIndex& sight);

/// Measures the box of one, two or three faces that belong together; its id stays unset. The axes
/// come from the normals, seen ends from the planes and outlines of the faces, and other ends are
/// bounded. Nullopt if it is no solid: a side is too long or too short, a face is not filled, or
/// something was seen within.
/// @param planes  all detected planes except the faces
std::optional<Box> measure_box(const std::vector<const Face*>& faces,
                               const std::vector<const Detection*>& planes,
                               const DirectionIndex& sight);

}  // namespace quadrille
