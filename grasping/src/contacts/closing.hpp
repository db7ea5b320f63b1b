#pragma once

#include <vector>

#include "contacts/contact_line.hpp"
#include "quadrille/grasping/collision_shape.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// True if both contacts lie on the pads or the fingers behind them, not past an edge or the tip.
bool on_pads(const ContactLine& line, const Eigen::Isometry3d& X_CG, const Gripper& gripper);

/// True if the closing fingers would meet the target elsewhere, farther out than at the contacts,
/// before they reach these: where it widens behind the pads, or bulges beside a chord.
/// @param target  the target's body as convex pieces
/// @param margin  how far out each contact may be after all [m]
bool meets_too_early(const ContactLine& line, const Eigen::Isometry3d& X_CG, const Gripper& gripper,
                     const std::vector<CollisionShape>& target, double margin);

/// True if one end of a chord leans much more than the other: there the tips touch elsewhere.
bool lopsided(const ContactLine& line, const Eigen::Vector3d& approach_C);

}  // namespace quadrille
