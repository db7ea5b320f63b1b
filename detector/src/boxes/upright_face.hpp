#pragma once

#include <optional>
#include <vector>

#include "boxes/box_draft.hpp"
#include "boxes/box_ends.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// The ends of a box of which only one upright face was found, because its other sides are turned
/// away or too narrow, round or oblique for a face. Nullopt unless the face rests on one plane, was
/// seen to end on its other three sides, is flat, and hides what lies behind it as a solid does.
///
/// The ends of the face move to the sides that begin at its edges. The end behind the face never
/// counts as seen: its likely depth is the one at which lines of sight past the edges of the face
/// pass behind the box.
/// @param draft   of the face
/// @param planes  all detected planes except the face
/// @param ends    what bounded() returns for the draft
std::optional<BoxEnds> find_upright_ends(const BoxDraft& draft,
                                         const std::vector<const Detection*>& planes,
                                         const BoxEnds& ends);

}  // namespace quadrille
