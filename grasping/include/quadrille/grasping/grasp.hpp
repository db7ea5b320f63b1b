#pragma once

#include <Eigen/Geometry>
#include <array>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/setting.hpp"

namespace quadrille {

/// How a grasp holds its target.
enum class GraspKind {
  kAcross,  ///< across the body, with the pads
  kEnd,     ///< on both ends of its axis
  kRim,     ///< across the wall of a vessel, at its rim
  kTip,     ///< with the tips alone, before the widest part
};

constexpr auto words_of(GraspKind) {
  return std::to_array<Word<GraspKind>>({{"across", GraspKind::kAcross},
                                         {"end", GraspKind::kEnd},
                                         {"rim", GraspKind::kRim},
                                         {"tip", GraspKind::kTip}});
}

/// One two-finger grasp. Frame G: origin midway between the pads, z approach, y closing.
struct Grasp {
  /// Id of the detection or box to be grasped.
  int target = 0;
  /// Its track; 0 if it has none.
  int track = 0;
  GraspKind kind = GraspKind::kAcross;
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

  /// Pose X_CG from which the hand, opened to its preshape, comes straight to the grasp; closed, it
  /// can go back there. All of this way was checked but for what it holds, which may stand on
  /// something: lift it first.
  Eigen::Isometry3d pregrasp() const {
    return X_CG * Eigen::Translation3d(-approach * Eigen::Vector3d::UnitZ());
  }
};

}  // namespace quadrille
