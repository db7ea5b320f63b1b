#pragma once

#include <vector>

#include "body/shell.hpp"
#include "contacts/contact_line.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// How far to either side a pad holds a wall [m]: the points of the wall within it count.
double rim_reach(const Gripper& gripper);

/// Contact lines across the wall, all around the rim, some millimetres below it: one pad inside,
/// one outside, each clear of the thickest wall and of its bend within the finger's width, and
/// midway between them a wall of mean thickness.
std::vector<ContactLine> rim_lines(const Shell& shell, const Gripper& gripper);

/// Those of the lines at which enough points of the wall were measured, with the deviation of these
/// points instead of the fit's: near them the wall is known, however badly its far side.
std::vector<ContactLine> measured_lines(const Shell& shell, const Gripper& gripper,
                                        const std::vector<ContactLine>& lines,
                                        const PointCloud& cloud);

}  // namespace quadrille
