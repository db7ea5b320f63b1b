#pragma once

#include <Eigen/Geometry>
#include <numbers>
#include <string>

#include "lab/physics/true_body.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille::physics {

/// Assumptions about objects and pads.
struct TrialOptions {
  /// Friction coefficient between pads and objects.
  double friction = 0.5;
  /// Density of all objects, about that of wood or of a half full cup [kg/m³].
  double density = 300.0;
  /// Closing force [N]; 0 means the gripper's own.
  double force = 0.0;

  /// @throws std::invalid_argument naming the field that is out of range
  void check() const;
};

/// An object that moves [m] or turns [rad] by at least this much has slipped or turned in the hand.
constexpr double kMaxSlip = 0.005, kMaxRotation = 5.0 * std::numbers::pi / 180.0;

/// The result of one trial.
struct TrialResult {
  /// True if both pads touched the object.
  bool touched = false;
  /// True if at the end the object hung between both pads, within 30 mm of where they took hold of
  /// it.
  bool lifted = false;
  /// How far the object's point between the pads has moved along them [m], and how far it has
  /// turned in the hand [rad] since the first touch; the maximum of each while both pads hold the
  /// object. The motion by which one pad pushes it towards the other is not slip, but rotation
  /// during that motion counts.
  double slip = 0.0, rotation = 0.0;
  /// True if the object was lifted with less than 5 mm of slip and 5° of rotation.
  bool held = false;
};

/// Explains which package this program was built without, so that nothing can be tried; empty if
/// nothing is missing.
std::string missing_physics();

/// Closes the hand on an object, lifts it and shakes it, in Bullet at 4 kHz.
///
/// The simulation runs in the hand's frame, where the hand's motion is an acceleration of
/// everything else. The pads close from the pre-shape with limited force, coupled as in real hands.
/// The object stands on the table; an object that would fall over by itself, as some do in
/// generated scenes, is propped up until the pads hold it. Then follow a lift by 80 mm at 2 m/s²
/// and a shake by half of gravity along x, y and z. Pads resist twisting like discs with a radius
/// of a quarter of their width. Only object, hand and table are simulated. The same input gives the
/// same bits.
/// @param grasp  only its X_CG, width and preshape are used
/// @param X_CT   the table's frame: z up, origin in its plane
/// @throws std::invalid_argument if gripper or options are out of range
/// @throws std::runtime_error with missing_physics() if that is not empty
TrialResult try_grasp(const TrueBody& body, const Gripper& gripper, const Grasp& grasp,
                      const Eigen::Isometry3d& X_CT, const TrialOptions& options = {});

}  // namespace quadrille::physics
