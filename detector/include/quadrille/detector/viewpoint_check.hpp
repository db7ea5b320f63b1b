#pragma once

#include <string>
#include <vector>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille {

/// Explains why a cloud cannot have been seen from its viewpoint; empty if nothing contradicts it.
///
/// A sensor looks to one side, is not inside what it sees, and does not see through surfaces. A
/// cloud fused from several views shows what one view would hide, and this is accepted; but in any
/// cloud, no plane may hide most of what lies around it.
/// @param detections  detections in the cloud, in its frame C; only planes are used
/// @return one sentence: what is wrong, where, and what to do
QUADRILLE_EXPORT std::string contradict_viewpoint(const CloudView& cloud,
                                                  const std::vector<Detection>& detections);

}  // namespace quadrille
