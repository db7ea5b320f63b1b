#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Detects the quadrics of one cloud by the method of Birdal et al., CVPR 2018.
///
/// Equal clouds, options and seeds give equal bits for any thread count.
/// @throws std::invalid_argument if an option is out of range (the message names the field)
QUADRILLE_EXPORT DetectionResult detect(const CloudView& cloud,
                                        const DetectorOptions& options = {});

/// Makes boxes from the planes among the detections of a cloud. detect() also makes boxes whose
/// faces are too small to be detected; this is for those who have only the detections.
///
/// Two or three planes are faces of one box if they meet at right angles, within 9°, in a common
/// convex edge. Faces that were not detected are sought in the cloud. A
/// single plane is the top of a box if it is a free-standing rectangle above a plane that is
/// parallel to it. Planes larger than 0.7 m are tables, walls and floors. Ids continue those of the
/// detections; boxes with the most detected faces come first. Deterministic.
/// @param cloud  cloud of the detections, with the viewpoint of its sensor
/// @return boxes in frame C of the cloud; one plane may hold faces of several, such as the tops of
///   boxes of equal height
QUADRILLE_EXPORT std::vector<Box> find_boxes(const CloudView& cloud,
                                             const std::vector<Detection>& detections);

}  // namespace quadrille
