#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "quadrille/detector/detection.hpp"

namespace quadrille::python {

/// The result of a detection, in the frame K in which it was made.
struct Found {
  DetectionResult in_K;
  /// Pose of K in the frame C of the cloud.
  Eigen::Isometry3d X_CK = Eigen::Isometry3d::Identity();
  /// The motion within C of each further view, which corrects its pose.
  std::vector<Eigen::Isometry3d> corrections_C = {};

  /// Returns the same in frame F. If that is K, all bits are kept.
  DetectionResult in(const Eigen::Isometry3d& X_CF) const;
  DetectionResult in_C() const { return in(Eigen::Isometry3d::Identity()); }
};

/// Makes a result of what the caller knows, or has of other results. Ids of 0 become the next free
/// numbers.
/// @throws std::invalid_argument if an id occurs twice or is below 0
Found found_of(std::vector<Detection> detections, std::vector<Box> boxes,
               std::vector<SceneBody> bodies);

/// Adds what the caller knows to what was found, with the next free numbers as ids.
/// @param detections, boxes  in frame C
Found with_known(Found found, std::vector<Detection> detections, std::vector<Box> boxes);

}  // namespace quadrille::python
