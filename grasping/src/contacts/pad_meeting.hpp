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

/// Where two pads meet a body.
struct PadMeeting {
  /// Its centre is the origin of the grasp frame.
  ContactLine line;
  /// The friction coefficient that it needs: for the line between the contacts, and for the pads on
  /// what lies within 1.5 mm of the contacts, which may be them in truth: tan θ, where cos θ is the
  /// mean cosine between the closing direction and the normals there [-].
  double friction;
};

/// Finds where the pads of a hand meet a body, on a grid of chords over the inner faces of its
/// fingers: not where the body is widest, but where it is so within their reach.
class PadMeetingFinder {
 public:
  /// @param body     no box; it and the gripper must outlive this
  PadMeetingFinder(const Body& body, const Gripper& gripper);
  PadMeetingFinder(const Body& body, Gripper&& gripper) = delete;

  /// From now on for a hand that closes along y and comes along z, unit vectors in frame C at right
  /// angles; before the first at().
  void turn(const Eigen::Vector3d& closing_C, const Eigen::Vector3d& approach_C);
  /// For a hand whose origin is moved along its closing direction from p_C. Nullopt if the fingers
  /// do not meet the body, meet more than they open, meet the edge of one of its ends, or need more
  /// friction than `max_friction`.
  std::optional<PadMeeting> at(const Eigen::Vector3d& p_C,
                               double max_friction = std::numeric_limits<double>::infinity());

 private:
  static constexpr int kRows = 8, kColumns = 5, kChords = kRows * kColumns;
  using Chords = Eigen::Array<float, kChords, 1>;

  bool on_edge(const ContactLine& line) const;
  bool too_wide(const Eigen::Vector3d& q_Q) const;
  bool cross(const Eigen::Vector3d& p_Q);
  double friction_between(const std::array<Eigen::Vector3d, 2>& ends_Q) const;
  double lean(int side, double outermost, const Eigen::Vector3d& p_Q) const;

  const Body& body_;
  const Gripper& gripper_;
  DiagonalQuadric quadric_;
  Eigen::Vector3d y_C_, y_Q_;
  /// Where the chords lie from the origin of G, with wᵀMw and wᵀMy of each such w, and yᵀMy: a
  /// chord lies inside between its ends if this is positive.
  Eigen::Matrix<double, 3, kChords> from_origin_Q_;
  std::array<Chords, 3> offsets_;  // the same, axis by axis
  Chords square_, product_;
  double curvature_ = 0.0;
  /// How far out the ends of each chord lie on either side; far within if it meets no surface.
  std::array<Chords, 2> out_;
};

}  // namespace quadrille
