#pragma once

#include <vector>

#include "base/cloud_runs.hpp"
#include "body/shell.hpp"
#include "contacts/contact_line.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// Returns how far to either side a pad holds a wall [m]; the points of the wall within this
/// distance count.
double rim_reach(const Gripper& gripper);

/// Returns contact lines across the wall, all around the rim, some millimetres below it: one pad
/// inside and one outside. Each pad is clear of the thickest wall and of its bend within the
/// finger's width; a wall of mean thickness lies midway between them.
std::vector<ContactLine> rim_lines(const Shell& shell, const Gripper& gripper);

/// Returns the lines at which enough points of the wall were measured. Their deviation is that of
/// these points instead of the fit's: the wall is well known near them, even if its far side is
/// not.
std::vector<ContactLine> measured_lines(const Shell& shell, const Gripper& gripper,
                                        const std::vector<ContactLine>& lines,
                                        const CloudRuns& cloud);

}  // namespace quadrille
