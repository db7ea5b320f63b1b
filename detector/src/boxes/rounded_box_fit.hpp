#pragma once

#include <vector>

#include "boxes/box_draft.hpp"
#include "boxes/box_ends.hpp"
#include "boxes/outline.hpp"

namespace quadrille {

/// Fits the ends of a box that are outlines, together with the radius of its edges. The residuals
/// are the distances of the points about its edges from the rounded box, with Tukey's weights, and
/// the distances of the ends from the outlines. Other ends stay as they are.
/// @param outlines  those that were seen
/// @param ends      each outline's end where the outline was seen; replaced by the fit
/// @return the radius [m], 0 for sharp edges
double fit_rounded_box(const BoxDraft& draft, const std::vector<Outline>& outlines, BoxEnds* ends);

}  // namespace quadrille
