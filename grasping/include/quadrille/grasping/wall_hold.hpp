#pragma once

#include <Eigen/Core>

#include "quadrille/grasping/contact_line.hpp"
#include "quadrille/grasping/rim.hpp"

namespace quadrille {

/// The direction that is nearest to into_C among those in the plane of the wall at a line: of a
/// hand that lies straight on the wall.
Eigen::Vector3d along_wall(const ContactLine& line, const Eigen::Vector3d& into_C);

/// How far the rim lies above the contacts, measured along the wall [m].
double rim_above(const Shell& shell, const ContactLine& line);

/// How far the corners of what the pads cover lie beside where they would lie straight on the wall,
/// since its bends around and up its axis differ [m]: with curvatures κ and κ', askew by φ, at
/// (x, z) that is (κ − κ') sin φ cos φ · x · z. It twists the wall in the hand until it lies
/// straight.
/// @param half_width  of the pads [m]
double wall_warp(const Shell& shell, const ContactLine& line, const Eigen::Vector3d& approach_C,
                 double half_width);

}  // namespace quadrille
