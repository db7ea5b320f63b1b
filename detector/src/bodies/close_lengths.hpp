#pragma once

#include <span>
#include <vector>

#include "bodies/common_axis.hpp"
#include "quadrille/detector/detection.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/last_fit.hpp"

namespace quadrille {

/// Ends the cylinders of a body where the next piece begins, such as the wall of a bottle where the
/// shoulder does.
///
/// The samples of a cylinder reach into a shoulder that leaves it slowly, or end before it. Both
/// surfaces meet where their profiles intersect. That height counts as the cylinder's end if it
/// lies within a gap between parts of one body, if the next piece begins near it, and if its
/// standard deviation makes that of the length smaller. The deviation follows from that of both
/// profiles there, divided by the difference of their slopes.
/// @param detections  the surfaces as they were measured; lengths and their deviations change
void close_lengths(const std::vector<LastFit>& fits, const SurfaceSamples& samples,
                   std::span<const CommonAxis> axes, std::vector<Detection>* detections);

}  // namespace quadrille
