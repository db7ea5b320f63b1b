#pragma once

#include <string>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/collision_shape.hpp"

namespace quadrille {

/// Shapes of a surface that bounds no solid, within the extent of its inliers: planes as slabs,
/// hyperbolic paraboloids, hyperbolic and parabolic cylinders as blocks along their tangent planes.
/// Each reaches some way behind the side that the sensor saw. Empty, and the reason in *why, for
/// any other type or an impossible size.
std::vector<CollisionShape> make_patch(const Detection& detection, std::string* why);

/// A native box.
CollisionShape make_box(const Eigen::Isometry3d& X_CQ, const Eigen::AlignedBox3d& box_Q);

}  // namespace quadrille
