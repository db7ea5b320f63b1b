#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "bodies/joint_member.hpp"
#include "fit/coaxial_fit.hpp"

namespace quadrille {

/// Numbers of the members that are the two sides of one wall, the outer one first.
using WallSides = std::vector<std::size_t>;

/// The largest member that was seen from outside, and those that were seen from inside. Empty if
/// there are none, or if no side of the wall is a cylinder or a cone alone.
WallSides straight_wall(const std::vector<Member>& members);

/// The mean of the axes of a wall's sides: a pose whose z axis is the axis. The near wall of a
/// tapered cup passes for a cylinder that leans one way, and the far wall for one that leans the
/// other way.
Eigen::Isometry3d mean_axis(const std::vector<Member>& members, const WallSides& wall);

/// Makes cylinders of the sides of a wall, or parallel cones, about an axis: the start of a fit.
void straighten(const std::vector<Member>& members, const WallSides& wall, Family family,
                const Eigen::Isometry3d& X_CA, std::vector<CoaxialPart>* parts);

}  // namespace quadrille
