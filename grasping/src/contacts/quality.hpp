#pragma once

#include "contacts/contact_line.hpp"

namespace quadrille {

/// Least friction coefficient that closes two opposite contacts: μ* = tan θ, θ the larger angle
/// between the line through the contacts and a normal (Nguyen); infinite from 90° on.
double friction_needed(const ContactLine& line);

/// Two soft-finger contacts.
struct ContactModel {
  /// Friction coefficient μ.
  double friction = 0.5;
  /// Torque about the normal that a unit normal force holds, γ [m].
  double torsion = 0.0017;
  /// Torques are divided by this length λ to compare with forces [m].
  double torque_scale = 0.05;
};

/// Quality ε: the largest wrench, of any direction, that a unit contact force resists.
///
/// For contacts along the closing line ε = min(γ/λ, μk/√(1 + k² + μ²k²)) with k = width / 2λ.
/// Normals that lean by θ leave of each friction cone at least a cone of half angle atan μ − θ
/// around the line, so μ is reduced to tan(atan μ − θ): a lower bound, 0 where the grasp does not
/// close.
double grasp_epsilon(const ContactLine& line, const ContactModel& model);

/// What a grasp is ranked by, each term from 0 to 1.
struct ScoreTerms {
  /// 1 − μ*/μ.
  double friction = 0.0;
  /// Clearance over 10 mm, at most 1.
  double clearance = 0.0;
  /// Share of the contacts next to which the surface was measured.
  double observed = 0.0;
  /// Room between each pad and the target on the way in, over 5 mm, at most 1.
  double room = 0.0;
  /// 1 at the target's centre, 0 at its far end: how short the lever of its weight is.
  double central = 0.0;
};

/// Weighted mean of the terms: .30 friction, .25 clearance, .20 observed, .15 room, .10 central.
double grasp_score(const ScoreTerms& terms);

}  // namespace quadrille
