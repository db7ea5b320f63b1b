#pragma once

#include <Eigen/Geometry>
#include <array>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/word.hpp"
#include "quadrille/grasping/grasp_terms.hpp"

namespace quadrille {

/// How a grasp holds its target.
enum class GraspKind {
  kAcross,  ///< across the body, with the pads
  kEnd,     ///< on both ends of the body's axis
  kRim,     ///< across the wall of a vessel, at its rim
  kTip,     ///< with the finger tips alone, in front of the body's widest part
};

constexpr auto words_of(GraspKind) {
  return std::to_array<Word<GraspKind>>({{"across", GraspKind::kAcross},
                                         {"end", GraspKind::kEnd},
                                         {"rim", GraspKind::kRim},
                                         {"tip", GraspKind::kTip}});
}

/// One two-finger grasp. Frame G: origin midway between the pads, z approach, y closing.
struct Grasp {
  /// Id of the detection, box or body to be grasped. A detection that is part of a body is grasped
  /// under the id of the body, unless the query names it.
  int target = 0;
  /// Track of the target, which is that of its body if it is no quadric; 0 if it has none.
  int track = 0;
  GraspKind kind = GraspKind::kAcross;
  /// Probability that the grasp succeeds.
  double score = 0.0;
  Eigen::Isometry3d X_CG = Eigen::Isometry3d::Identity();
  /// Distance between the contacts [m], and opening of the hand on its way in [m].
  double width = 0.0, preshape = 0.0;
  /// Contact points in frame C [m].
  std::array<Eigen::Vector3d, 2> contacts_C;
  /// Length of the straight approach that was checked [m].
  double approach = 0.0;
  /// Least friction coefficient μ* that closes the grasp. For a hold by the finger tips this is the
  /// worst case over all places where the contacts may lie, given how well they are known.
  double friction_needed = 0.0;
  /// Grasp quality ε: the largest wrench, of any direction, that a unit contact force resists.
  double epsilon = 0.0;
  /// Distance by which the hand may be inflated before it touches anything other than the target
  /// [m].
  double clearance = 0.0;
  /// True if a contact lies on a part of the target that was not observed.
  bool unknown_contact = false;
  /// The terms from which the score is computed.
  GraspTerms terms;

  /// Returns the pose X_CG from which the hand, opened to its preshape, moves straight to the
  /// grasp. The closed hand can retreat there as well. The whole path was checked, but not the held
  /// object, which may rest on something: lift it before retreating.
  Eigen::Isometry3d pregrasp() const {
    return X_CG * Eigen::Translation3d(-approach * Eigen::Vector3d::UnitZ());
  }
};

}  // namespace quadrille
