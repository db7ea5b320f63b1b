#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <lcmtypes/quadrille/robot_t.hpp>
#include <vector>

#include "lab/scene/surface.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// The robot's own opened hand as a camera at its wrist has it in every picture.
///
/// The camera sits beside the palm, on the side of x in the hand's frame G, so that neither finger
/// hides the other, and is tilted towards the grasp: the fingers come into the picture from below.
class WristHand {
 public:
  explicit WristHand(const Gripper& gripper);

  /// Returns the hand as a body of a scene.
  /// @param X_WK  pose of the camera in the scene's frame
  scene::Body body(const Eigen::Isometry3d& X_WK) const;

  /// Returns the message that tells the hand's shapes, in the camera's frame.
  /// @param utime  time of the picture [us]
  robot_t message(std::int64_t utime) const;

  /// Pose of the grasp frame in the camera's frame.
  const Eigen::Isometry3d& X_KG() const { return X_KG_; }

 private:
  Eigen::Isometry3d X_KG_;
  /// Both fingers and the palm, in G [m].
  std::vector<Eigen::AlignedBox3d> boxes_G_;
};

}  // namespace quadrille
