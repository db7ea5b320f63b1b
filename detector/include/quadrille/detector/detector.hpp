#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/eigen_layout.hpp"
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

/// Detects the quadrics of one scene at rest in several clouds, all in the frame of the first, each
/// with its own viewpoint. What one view found is refitted to what all views show of it, and judged
/// by all of them. Views whose poses are known from the arm or a calibration are first brought onto
/// each other by align_views().
///
/// If there is a single cloud, the result is that of detect(). Views without usable points are left
/// out, with a warning.
/// @param views  at least one
/// @throws std::invalid_argument if there is no view, or an option is out of range
QUADRILLE_EXPORT DetectionResult detect_views(std::span<const PointCloud> views,
                                              const DetectorOptions& options = {});

/// Prepares several views of a scene at rest for detect_views() and for the planner.
///
/// Each further view is brought onto the ones before by a small motion, which corrects the error of
/// its pose. It is sought on what the views both see, within the errors that DetectorOptions::views
/// says the poses have. A view that has too little in common with the ones before, or would have to
/// move by much more, stays as it is. Then the points that another view sees through are dropped:
/// no surface is there. In an organised cloud they become NaN.
/// @param views  clouds in one frame C, each with its own viewpoint
/// @return the motion within C of each view; the identity for the first
/// @throws std::invalid_argument if an option is out of range
QUADRILLE_EXPORT std::vector<Eigen::Isometry3d> align_views(std::vector<PointCloud>* views,
                                                            const DetectorOptions& options = {});

/// Makes boxes from the planes among the detections of a cloud. detect() also makes boxes whose
/// faces are too small to be detected; this is for those who have only the detections.
///
/// Two or three planes are faces of one box if they meet at right angles, within 9°, in a common
/// convex edge. Faces that were not detected are sought in the cloud. A
/// single plane is the top of a box if it is a free-standing rectangle above a plane that is
/// parallel to it. It is the front of a box if it stands upright on a plane, is a rectangle of at
/// most 0.35 m that was seen to end on the other three sides, and lines of sight past its edges
/// show nothing right behind it; the depth of the box then counts as not seen. Planes larger than
/// 0.7 m are tables, walls and floors. Ids continue those of the detections; boxes with the most
/// detected faces come first. Deterministic.
/// @param cloud  cloud of the detections, with the viewpoint of its sensor
/// @return boxes in frame C of the cloud; one plane may hold faces of several, such as the tops of
///   boxes of equal height
QUADRILLE_EXPORT std::vector<Box> find_boxes(const CloudView& cloud,
                                             const std::vector<Detection>& detections);

}  // namespace quadrille
