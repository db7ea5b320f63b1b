#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"

namespace quadrille {

/// A box of which one, two or three faces were detected as planes.
struct Box {
  /// Continues the ids of the detections.
  int id = 0;
  /// Ids of the detections that are its faces, those with more points first.
  std::vector<int> faces;
  /// Mean confidence of its faces, 0 to 1.
  double score = 0.0;
  /// Pose of frame B: origin at the middle, the longest side along x, the shortest along z; x and z
  /// point to the sensor's side.
  Eigen::Isometry3d X_CB = Eigen::Isometry3d::Identity();
  /// Sides along x, y, z, and their standard deviations [m]. Of a side that was not seen the most
  /// likely length, and the deviation of a length that is anywhere between its bounds.
  Eigen::Vector3d size = Eigen::Vector3d::Zero(), std = Eigen::Vector3d::Zero();
  /// Whether both ends of the side were seen.
  std::array<bool, 3> seen = {false, false, false};
  /// What was seen of it, and what it may reach at most without hiding what was seen behind it or
  /// crossing a plane, in frame B [m]. Both end where the box does, but for ends that were not
  /// seen.
  Eigen::AlignedBox3d inner_B, outer_B;
};

/// False for what was found but not asked for, as its faces: it is only in the way.
inline bool is_reported(const Box& box) { return box.faces.empty() || box.faces.front() >= 0; }

}  // namespace quadrille
