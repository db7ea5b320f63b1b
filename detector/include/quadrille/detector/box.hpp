#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"

namespace quadrille {

/// A box of which one, two or three faces were detected as planes.
struct Box {
  /// Number of the box, which continues the ids of the detections.
  int id = 0;
  /// Ids of the detections that are faces of the box, those with more points first.
  std::vector<int> faces;
  /// Mean confidence of the faces, 0 to 1.
  double score = 0.0;
  /// Pose of frame B: the origin is the middle of the box, the longest side runs along x and the
  /// shortest along z; x and z point to the sensor's side.
  Eigen::Isometry3d X_CB = Eigen::Isometry3d::Identity();
  /// Lengths of the sides along x, y, z, and their standard deviations [m]. For a side that was not
  /// seen, they are its most likely length and the deviation of a length uniform between its
  /// bounds.
  Eigen::Vector3d size = Eigen::Vector3d::Zero(), std = Eigen::Vector3d::Zero();
  /// True if both ends of the side were seen.
  std::array<bool, 3> seen = {false, false, false};
  /// The part that was seen, and the most that the box may occupy without hiding what was seen
  /// behind it or crossing a plane, in frame B [m]. They differ only at ends that were not seen.
  Eigen::AlignedBox3d inner_B, outer_B;
};

/// False if the box was found but not asked for, like its faces; it then only is an obstacle.
inline bool is_reported(const Box& box) { return box.faces.empty() || box.faces.front() >= 0; }

}  // namespace quadrille
