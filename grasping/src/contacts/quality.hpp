#pragma once

#include "contacts/contact_line.hpp"

namespace quadrille {

/// Returns the least friction coefficient that closes two opposite contacts: μ* = tan θ, where θ is
/// the larger angle between the line through the contacts and a normal (Nguyen); infinite from 90°
/// on.
double friction_needed(const ContactLine& line);

/// Friction model of two soft-finger contacts.
struct ContactModel {
  /// Friction coefficient μ.
  double friction = 0.5;
  /// Torque about the normal that a unit normal force resists, γ [m].
  double torsion = 0.0017;
  /// Torques are divided by this length λ to compare with forces [m].
  double torque_scale = 0.05;
};

/// Computes the quality ε: the largest wrench, in any direction, that a unit contact force resists.
///
/// For contacts along the closing line ε = min(γ/λ, μk/√(1 + k² + μ²k²)) with k = width / 2λ. If
/// normals lean by θ, each friction cone still contains a cone of half angle atan μ − θ around the
/// line, so μ is reduced to tan(atan μ − θ). This gives a lower bound, which is 0 if the grasp does
/// not close.
double grasp_epsilon(const ContactLine& line, const ContactModel& model);

/// The terms by which grasps are ranked, each from 0 to 1.
struct ScoreTerms {
  /// Friction to spare, 1 − μ*/μ.
  double friction = 0.0;
  /// Clearance divided by 10 mm, at most 1.
  double clearance = 0.0;
  /// Share of the contacts beside which the surface was measured.
  double observed = 0.0;
  /// Room between each pad and the target on the way in, divided by 5 mm, at most 1.
  double room = 0.0;
  /// 1 at the target's centre, 0 at its far end: a grasp near the centre leaves the target's weight
  /// a short lever.
  double central = 0.0;
};

/// Returns the weighted mean of the terms: .30 friction, .25 clearance, .20 observed, .15 room, .10
/// central.
double grasp_score(const ScoreTerms& terms);

}  // namespace quadrille
