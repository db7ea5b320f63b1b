#pragma once

#include <string>
#include <vector>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille {

/// Why a cloud cannot have been seen from its viewpoint; empty if nothing speaks against that.
///
/// A sensor looks to one side, is not within what it sees, and does not see through surfaces. A
/// cloud fused from several views shows what one view would hide, and is not blamed for that; but
/// whatever the cloud, no plane may hide most of what lies about it.
/// @param detections  what was found in the cloud, in its frame C; of these the planes count
/// @return one sentence: what is wrong, where, and what to do
QUADRILLE_EXPORT std::string contradict_viewpoint(const CloudView& cloud,
                                                  const std::vector<Detection>& detections);

}  // namespace quadrille
