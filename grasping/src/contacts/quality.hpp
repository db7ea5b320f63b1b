#pragma once

#include "contacts/contact_line.hpp"

namespace quadrille {

/// Returns the least friction coefficient that closes two opposite contacts: μ* = tan θ, where θ is
/// the larger angle between the line through the contacts and a normal (Nguyen); infinite from 90°
/// on.
double friction_needed(const ContactLine& line);

/// Returns the friction coefficient that a hold may need if the angle that demands `friction` may
/// be larger by `lean_std` [rad].
double doubted_friction(double friction, double lean_std);

/// Returns the friction coefficient that a pair of contacts may need, given how well their lean is
/// known. This decides whether the pair is refused, and enters the score.
double doubted_friction(const ContactLine& line);

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

}  // namespace quadrille
