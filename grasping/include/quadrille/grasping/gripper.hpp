#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille {

/// A parallel-jaw hand as boxes in the grasp frame G: origin midway between the finger pads,
/// z along the approach, y along the closing direction.
struct Gripper {
  std::string name;
  /// Largest and smallest distance between the pads [m].
  double max_opening = 0.0, min_opening = 0.0;
  /// Size of one finger along x, y (thickness) and z, from its back to its tip, at the largest
  /// opening [m].
  Eigen::Vector3d finger = Eigen::Vector3d::Zero();
  /// Distance by which the finger tip extends beyond the origin of G along z [m].
  double finger_front = 0.0;
  /// The pad that touches the object, centred at the origin of G: size along x and z [m].
  Eigen::Vector2d pad = Eigen::Vector2d::Zero();
  /// The palm, whose front face lies at the back of the fingers: size along x, y and z [m].
  Eigen::Vector3d palm = Eigen::Vector3d::Zero();
  /// Largest closing force [N].
  double max_force = 0.0;
  /// Length of the links on which the fingers swing [m], and the angle between the links and the
  /// approach at the largest opening [rad]. Each finger is guided by a parallelogram, so that the
  /// pads stay parallel. Both are 0 if the fingers slide straight.
  double link_length = 0.0, link_angle = 0.0;
  /// Distance from the origin of the hand's own frame (its link in a robot's description) to the
  /// origin of G along the approach, at the largest opening [m]. 0 means that the hand's frame lies
  /// at the back of the palm.
  double tcp = 0.0;

  /// Returns how much farther from the palm the tips lie at this opening than at the largest one
  /// [m]. With the links' length L and angle φ this is L(cos ψ − cos φ), where
  /// sin ψ = sin φ − (max − opening)/2L.
  QUADRILLE_EXPORT double extension(double opening) const;
  /// Returns the largest extension over all openings from `narrow` to `wide` [m].
  QUADRILLE_EXPORT double max_extension(double narrow, double wide) const;
  /// Returns the distance from the palm's front to the origin of G when the hand is closed to a
  /// width [m].
  QUADRILLE_EXPORT double reach(double width) const;

  /// @throws std::invalid_argument naming the field that contradicts the others, and the remedy
  QUADRILLE_EXPORT void check() const;
};

/// The Franka Hand, with the sizes given in the manufacturer's description.
QUADRILLE_EXPORT Gripper franka_hand();

/// The Schunk WSG 50 with its standard fingers, for objects too wide for the Franka Hand.
QUADRILLE_EXPORT Gripper schunk_wsg50();

/// The Robotiq 2F-85 with its flat pads and the Robotiq 2F-140 with its large rubber pads.
QUADRILLE_EXPORT Gripper robotiq_2f85();
QUADRILLE_EXPORT Gripper robotiq_2f140();

/// Returns all of these, in the order of their names.
QUADRILLE_EXPORT std::vector<Gripper> built_in_grippers();

/// Returns a built-in gripper by name ("franka", "robotiq_2f140", "robotiq_2f85", "wsg50").
/// @throws std::invalid_argument listing the known names
QUADRILLE_EXPORT Gripper gripper_by_name(const std::string& name);

}  // namespace quadrille
