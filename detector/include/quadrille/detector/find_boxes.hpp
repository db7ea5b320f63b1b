#pragma once

#include <vector>

#include "quadrille/detector/box.hpp"
#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille {

/// Makes boxes of the planes among the detections of a cloud.
///
/// Two or three planes are faces of one box if they meet at right angles, as far as their normals
/// are known, in an edge that they share and that the box lies behind. Faces that
/// were not detected are looked for in the cloud. One plane alone is taken for the top of a box if
/// it is a free-standing rectangle over a plane that is parallel to it. Planes of more than 0.7 m
/// are tables, walls and floors. Ids continue those of the detections; the
/// largest boxes come first. Deterministic.
/// @param cloud  from which the detections come, with the viewpoint of its sensor
/// @return boxes in frame C of the cloud; one plane may hold faces of several, as the tops of boxes
///         of one height
QUADRILLE_EXPORT std::vector<Box> find_boxes(const CloudView& cloud,
                                             const std::vector<Detection>& detections);

}  // namespace quadrille
