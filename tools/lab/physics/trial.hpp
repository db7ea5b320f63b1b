#pragma once

#include <Eigen/Geometry>
#include <numbers>
#include <string>

#include "lab/physics/true_body.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille::physics {

/// What is assumed of objects and pads.
struct TrialOptions {
  /// Friction coefficient between pads and objects.
  double friction = 0.5;
  /// Of all objects, about that of wood or of a half full cup [kg/m³].
  double density = 300.0;
  /// Closing force [N]; 0: the gripper's own.
  double force = 0.0;

  /// @throws std::invalid_argument naming the field that is out of range
  void check() const;
};

/// From so much on an object has slipped [m] or turned [rad] in the hand.
constexpr double kMaxSlip = 0.005, kMaxRotation = 5.0 * std::numbers::pi / 180.0;

/// What became of one grasp.
struct TrialResult {
  /// Both pads touched the object.
  bool touched = false;
  /// At the end it hung between both pads, within 30 mm of where they took hold of it.
  bool lifted = false;
  /// How far the object's point between the pads has moved along them [m], and how far it has
  /// turned in the hand [rad], since the first touch: the most of each while both pads have hold of
  /// it. The way that one pad pushes it to the other is no slip, but what it turns meanwhile
  /// counts.
  double slip = 0.0, rotation = 0.0;
  /// Lifted, with less than 5 mm of slip and 5° of rotation.
  bool held = false;
};

/// Why nothing can be tried: which package this program was built without; empty if all is there.
std::string missing_physics();

/// Closes the hand on an object, lifts it and shakes it, in Bullet at 4 kHz.
///
/// In the hand's frame, where its motion is an acceleration of everything else: the pads close from
/// the pre-shape with their force limited, coupled as in real hands. The object stands on the
/// table; one that would fall over by itself, as some in generated scenes, is propped up until the
/// pads hold it. Then come the lift by 80 mm at 2 m/s² and a shake of half of gravity along x, y
/// and z. Pads resist twisting as discs of a quarter of their width in radius do. Nothing but
/// object, hand and table is there. The same input gives the same bits.
/// @param grasp  its X_CG, width and preshape count
/// @param X_CT   the table's frame: z up, origin in its plane
/// @throws std::invalid_argument if gripper or options are out of range
/// @throws std::runtime_error with missing_physics() if that is not empty
TrialResult try_grasp(const TrueBody& body, const Gripper& gripper, const Grasp& grasp,
                      const Eigen::Isometry3d& X_CT, const TrialOptions& options = {});

}  // namespace quadrille::physics
