#pragma once

#include <Eigen/Geometry>
#include <array>

namespace quadrille {

/// One two-finger grasp. Frame G: origin midway between the pads, z approach, y closing.
struct Grasp {
  /// Id of the detection or box to be grasped.
  int target = 0;
  /// 0 to 1, best first.
  double score = 0.0;
  Eigen::Isometry3d X_CG = Eigen::Isometry3d::Identity();
  /// Distance between the contacts [m], and opening of the hand on its way in [m].
  double width = 0.0, preshape = 0.0;
  /// Contact points in frame C [m].
  std::array<Eigen::Vector3d, 2> contacts_C;
  /// Length of the straight approach that was checked [m].
  double approach = 0.0;
  /// Least friction coefficient μ* that closes the grasp; of a hold by the tips, with the contacts
  /// where they are least good within what is known of them.
  double friction_needed = 0.0;
  /// Grasp quality ε: the largest wrench, of any direction, that a unit contact force resists.
  double epsilon = 0.0;
  /// Distance by which the hand may be inflated before it touches anything but the target [m].
  double clearance = 0.0;
  /// True if a contact lies on a part of the target that was not observed.
  bool unknown_contact = false;
};

}  // namespace quadrille
