#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "body/body.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// Two opposite contacts of flat, parallel pads with a body, in closed form.
struct ContactLine {
  /// Origin of the grasp frame, in frame C [m]. It lies midway between the contacts, except for
  /// contacts found by PadMeetingFinder (see PadMeeting).
  Eigen::Vector3d centre_C = Eigen::Vector3d::Zero();
  /// Unit closing direction, from contact 1 to contact 0.
  Eigen::Vector3d closing_C = Eigen::Vector3d::UnitY();
  std::array<Eigen::Vector3d, 2> contacts_C;
  /// Outward unit normals of the body at the contacts.
  std::array<Eigen::Vector3d, 2> normals_C;
  /// Distance between the pads when they touch [m].
  double width = 0.0;
  /// Largest size of the body along the closing direction, over the part that the pads pass [m].
  double opening = 0.0;
  /// Standard deviation of half the width [m].
  double std = 0.0;
  /// Standard deviation of the angles between the line and the normals [rad].
  double lean_std = 0.0;
};

/// Returns contact lines all over a body: across the axis at many heights, end-on for cylinders and
/// slabs, in all directions for ellipsoids. A flat pad touches a convex cross-section at the
/// support point of the closing direction d: for semi-axes A that is ±A²d/√(dᵀA²d), and half the
/// width is √(dᵀA²d). Directions across the line of sight are sampled most densely, since both pads
/// then stay in seen space. Level directions are sampled too, since a hand from straight above
/// closes along them.
/// @param viewpoint_C  position of the sensor [m]
/// @param up_C  upward normal of the support; zero if it is not known
std::vector<ContactLine> contact_lines(const Body& body, const Gripper& gripper,
                                       const Eigen::Vector3d& viewpoint_C,
                                       const Eigen::Vector3d& up_C = Eigen::Vector3d::Zero());

/// Returns where the line p + t·d passes through the body: the contacts of a grasp beside its
/// widest part, from the roots of the quadric along the line. Nullopt if the line misses the body
/// or meets one of its ends.
std::optional<ContactLine> chord(const Body& body, const Eigen::Vector3d& p_C,
                                 const Eigen::Vector3d& d_C);

}  // namespace quadrille
