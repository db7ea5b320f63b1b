#pragma once

#include <optional>
#include <vector>

#include "boxes/box_draft.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// True if what was seen of a face that stands alone fills the rectangle around it including the
/// corners, which no disc does.
bool is_rectangular(const BoxDraft& draft);

/// Measures the box of one, two or three faces that belong together; its id stays unset. The axes
/// come from the normals, seen ends from the planes and outlines of the faces, and other ends are
/// bounded. Nullopt if it is no solid: a side is too long or too short, a face is not filled, or
/// something was seen within.
/// @param draft   of a single face only if it is rectangular
/// @param planes  all detected planes except the faces
std::optional<Box> measure_box(const BoxDraft& draft, const std::vector<const Detection*>& planes);

}  // namespace quadrille
