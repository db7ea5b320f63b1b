#pragma once

#include <optional>
#include <vector>

#include "boxes/box_draft.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Tells whether a face that stands alone fills the rectangle around it. A disc does not fill the
/// corners (kNone), a worn box fills them in part (kWorn), and other boxes do (kSharp).
enum class Rectangle { kNone, kWorn, kSharp };
Rectangle rectangle_of(const BoxDraft& draft);

/// Measures the box of two or three faces that belong together; its id stays unset. The axes
/// come from the normals, seen ends from the planes and outlines of the faces, and other ends are
/// bounded. Nullopt if it is no solid: a side is too long or too short, a face is not filled, or
/// something was seen within.
/// @param planes  all detected planes except the faces
std::optional<Box> measure_box(const BoxDraft& draft, const std::vector<const Detection*>& planes);

/// Measures the box of which only the top was found, a face with sharp corners, like measure_box().
/// Nullopt if no plane below is parallel to it.
std::optional<Box> measure_top(const BoxDraft& draft, const std::vector<const Detection*>& planes);

/// Measures the box of which only one upright face was found (find_upright_ends()), like
/// measure_box(). The corners of the face may be worn.
std::optional<Box> measure_upright(const BoxDraft& draft,
                                   const std::vector<const Detection*>& planes);

}  // namespace quadrille
