#pragma once

#include <Eigen/Core>

#include "body/shell.hpp"
#include "contacts/contact_line.hpp"

namespace quadrille {

/// Returns the unit vector nearest to the unit vector into_C in the plane of the wall at a line:
/// the approach of a hand that lies straight on the wall. Zero if into_C is the closing direction.
Eigen::Vector3d along_wall(const ContactLine& line, const Eigen::Vector3d& into_C);

/// Returns the distance from the contacts up to the rim, measured along the wall, which counts as
/// no flatter than a slope of 17° [m].
double rim_above(const Shell& shell, const ContactLine& line);

/// Returns the geodesic torsion of the wall along a hand's approach: (κ − κ') sin φ cos φ with the
/// curvatures κ around its axis and κ' up it, and φ between the approach and the wall's meridian
/// (do Carmo, Differential Geometry of Curves and Surfaces, 3-2) [1/m]. Exact for shells of
/// revolution; never negative.
double geodesic_torsion(const Shell& shell, const ContactLine& line,
                        const Eigen::Vector3d& approach_C);

/// Returns how far the corners of the pads' contact area lie beside a wall on which the pad lay
/// straight [m]: a point at x across and z along the approach is off by the geodesic torsion times
/// x z. This twists the wall in the hand until it lies straight.
/// @param half_width  half the width of the pads [m]
double wall_warp(const Shell& shell, const ContactLine& line, const Eigen::Vector3d& approach_C,
                 double half_width);

}  // namespace quadrille
