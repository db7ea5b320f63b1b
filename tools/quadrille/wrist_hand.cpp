#include "quadrille/wrist_hand.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "lab/scene/bodies.hpp"
#include "lab/scene/camera.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/robot_shapes.hpp"

namespace quadrille {
namespace {

using Eigen::Vector3d;

// The camera's distance from the side of the palm, about that of a camera on a bracket, and how far
// it sits behind the palm's front, so that the palm stays below the picture [m].
constexpr double kBeside = 0.04, kBehind = 0.03;
// Tangent of half the tilt, 25 degrees: with less, the fingers of a short hand lie below the
// picture.
constexpr double kTilt = 0.2217;

/// Both fingers at the largest opening, and the palm, in G.
std::vector<Eigen::AlignedBox3d> boxes_of(const Gripper& gripper) {
  const double tip = gripper.finger_front, back = -gripper.reach(gripper.max_opening);
  const Vector3d finger(0.5 * gripper.finger.x(), gripper.finger.y(), 0.0);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const double side : {-1.0, 1.0}) {
    const double inner = side * 0.5 * gripper.max_opening, outer = inner + side * finger.y();
    boxes.emplace_back(Vector3d(-finger.x(), std::min(inner, outer), back),
                       Vector3d(finger.x(), std::max(inner, outer), tip));
  }
  const Vector3d palm = 0.5 * gripper.palm;
  boxes.emplace_back(Vector3d(-palm.x(), -palm.y(), back - gripper.palm.z()),
                     Vector3d(palm.x(), palm.y(), back));
  return boxes;
}

/// Returns the pose X_KG of the hand in the frame K of the camera at its wrist.
Eigen::Isometry3d pose_of_hand(const Gripper& gripper) {
  constexpr double kCosine = (1.0 - kTilt * kTilt) / (1.0 + kTilt * kTilt);
  constexpr double kSine = 2.0 * kTilt / (1.0 + kTilt * kTilt);
  Eigen::Isometry3d X_KG;
  X_KG.setIdentity();
  // The approach points forward and up in the picture, and the fingers close along its rows.
  X_KG.linear() << 0.0, -1.0, 0.0, kCosine, 0.0, -kSine, kSine, 0.0, kCosine;
  X_KG.translation() = X_KG.linear() * Vector3d(0.5 * gripper.palm.x() + kBeside, 0.0,
                                                gripper.reach(gripper.max_opening) + kBehind);
  return X_KG;
}

}  // namespace

WristHand::WristHand(const Gripper& gripper)
    : X_KG_(pose_of_hand(gripper)), boxes_G_(boxes_of(gripper)) {}

scene::Body WristHand::body(const Eigen::Isometry3d& X_WK) const {
  scene::Body hand;
  hand.type = "hand";
  hand.X_WB = X_WK * X_KG_;
  for (const Eigen::AlignedBox3d& box_G : boxes_G_) {
    scene::Body part = scene::make_box(0.5 * box_G.sizes());
    // A box stands on its frame.
    const Vector3d foot(box_G.center().x(), box_G.center().y(), box_G.min().z());
    for (std::size_t n = 0; n < part.surfaces.size(); ++n) {
      hand.surfaces.push_back(std::move(part.surfaces[n]));
      hand.X_BS.push_back(Eigen::Translation3d(foot) * part.X_BS[n]);
    }
  }
  return hand;
}

robot_t WristHand::message(std::int64_t utime) const {
  robot_t robot{};
  robot.utime = utime;
  robot.frame = scene::kCameraFrame;
  robot.padding = RobotShapes{}.padding;
  for (const Eigen::AlignedBox3d& box_G : boxes_G_) {
    collision_shape_t& shape = robot.shapes.emplace_back();
    shape.kind = "box";
    shape.pose = bus::to_message(Eigen::Isometry3d(X_KG_ * Eigen::Translation3d(box_G.center())));
    const Vector3d size = box_G.sizes();
    shape.dimensions.assign(size.data(), size.data() + 3);
    shape.num_dimensions = 3;
  }
  robot.num_shapes = static_cast<std::int32_t>(robot.shapes.size());
  return robot;
}

}  // namespace quadrille
