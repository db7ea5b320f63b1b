#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/collision_shape.hpp"

namespace quadrille {

/// Makes shapes for a surface that bounds no solid, within the extent of its inliers: slabs for
/// planes; blocks along the tangent planes for hyperbolic paraboloids, hyperbolic and parabolic
/// cylinders. Each extends some way behind the side that the sensor saw. Empty for any other type
/// or an impossible size.
std::vector<CollisionShape> make_patch(const Detection& detection);

/// Makes a native box.
CollisionShape make_box(const Eigen::Isometry3d& X_CQ, const Eigen::AlignedBox3d& box_Q);

}  // namespace quadrille
