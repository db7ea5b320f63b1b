#pragma once

#include <vector>

#include "contacts/contact_line.hpp"
#include "quadrille/grasping/collision_shape.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// Returns true if both contacts lie on the pads or the fingers behind them, not past an edge or
/// the tip.
bool on_pads(const ContactLine& line, const Eigen::Isometry3d& X_CG, const Gripper& gripper);

/// Returns true if the closing fingers would touch the target elsewhere before they reach the
/// contacts: where it widens behind the pads, or bulges beside a chord.
/// @param target  the target's body as convex pieces
/// @param margin  how much farther out each contact may lie than computed [m]
bool meets_too_early(const ContactLine& line, const Eigen::Isometry3d& X_CG, const Gripper& gripper,
                     const std::vector<CollisionShape>& target, double margin);

/// Returns true if one end of a chord leans much more than the other: there the tips would touch
/// the body elsewhere.
bool lopsided(const ContactLine& line, const Eigen::Vector3d& approach_C);

}  // namespace quadrille
