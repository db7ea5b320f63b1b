#pragma once

#include <Eigen/Core>

#include "contacts/contact_line.hpp"

namespace quadrille {

/// Evidence from measured points for the two contacts of a hold.
struct ContactEvidence {
  /// Share of the contacts at which the side that the pad touches was seen.
  double seen = 0.0;
  /// Mean cosine between the pads' directions and the normals of the points next to them.
  double facing = 0.0;
  /// Share of the contacts that are PadSide::inner.
  double inner = 0.0;
  /// How far the points next to each contact reach along the approach, the lesser of the two [m].
  double height = 0.0;
  /// Share of the pads' area between which there are points.
  double filled = 0.0;
  /// Share of the pads' area at which these reach out nearly as far as the outermost one there, the
  /// lesser of the two pads.
  double flat = 0.0;
};

/// Contacts that a hand finds from one place, and its approach.
struct Hold {
  /// The contact line, whose centre is the origin of the grasp frame.
  ContactLine line;
  Eigen::Vector3d approach_C;
  /// The friction coefficient that the hold needs [-].
  double friction = 0.0;
  ContactEvidence evidence = {};
  /// True if one contact lies on the hidden side of a thin wall, of which the thickness is a guess.
  bool guessed = false;
};

}  // namespace quadrille
