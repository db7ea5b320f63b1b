#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>

#include "body/body.hpp"
#include "body/diagonal_quadric.hpp"
#include "contacts/contact_line.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// The contacts at which two pads meet a body.
struct PadMeeting {
  /// The contact line, whose centre is the origin of the grasp frame.
  ContactLine line;
  /// The friction coefficient that the hold needs [-], for the line between the contacts and for
  /// the pads on all points within 1.5 mm of the contacts, any of which may be the true contact.
  /// The latter is tan θ, where cos θ is the mean cosine between the closing direction and the
  /// normals there.
  double friction;
};

/// Finds where the pads of a hand of one orientation meet a body, on a grid of chords over the
/// inner faces of its fingers. The pads meet the body where it is widest within their reach, not
/// where it is widest overall.
class PadMeetingFinder {
 public:
  /// The hand closes along y and approaches along z, unit vectors in frame C at right angles.
  /// @param body  any body except a box; it and the gripper must outlive this finder
  PadMeetingFinder(const Body& body, const Gripper& gripper, const Eigen::Vector3d& closing_C,
                   const Eigen::Vector3d& approach_C);
  PadMeetingFinder(const Body& body, Gripper&& gripper, const Eigen::Vector3d& closing_C,
                   const Eigen::Vector3d& approach_C) = delete;

  /// Finds the contacts of a hand whose origin is p_C, moved along its closing direction as needed.
  /// Nullopt if the fingers do not meet the body, would have to open farther than the hand can or
  /// than `max_width` [m], meet the edge of one of its ends, or need more friction than
  /// `max_friction`.
  std::optional<PadMeeting> at(const Eigen::Vector3d& p_C,
                               double max_friction = std::numeric_limits<double>::infinity(),
                               double max_width = std::numeric_limits<double>::infinity());

 private:
  static constexpr int kRows = 8, kColumns = 5, kChords = kRows * kColumns;
  using Chords = Eigen::Array<float, kChords, 1>;

  bool on_edge(const ContactLine& line) const;
  bool too_wide(const Eigen::Vector3d& q_Q, double max_width) const;
  struct Crossing;
  bool cross_all(const Crossing& crossing);
  bool cross(const Eigen::Vector3d& p_Q);
  double friction_between(const std::array<Eigen::Vector3d, 2>& ends_Q) const;
  double lean(int side, double outermost, const Eigen::Vector3d& p_Q) const;

  const Body& body_;
  const Gripper& gripper_;
  DiagonalQuadric quadric_;
  Eigen::Vector3d y_C_, y_Q_;
  /// Positions w of the chords relative to the origin of G, with wᵀMw and wᵀMy for each w, and
  /// yᵀMy. If the last is positive, a chord lies inside the body between its ends.
  Eigen::Matrix<double, 3, kChords> from_origin_Q_;
  std::array<Chords, 3> offsets_;  // the same positions, axis by axis
  Chords square_, product_;
  double curvature_ = 0.0;
  /// How far out the ends of each chord lie on either side; far inside if the chord meets no
  /// surface. The farthest on either side.
  std::array<Chords, 2> out_;
  std::array<float, 2> farthest_;
};

}  // namespace quadrille
