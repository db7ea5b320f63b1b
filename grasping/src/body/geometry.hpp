#pragma once

#include "quadrille/grasping/collision_shape.hpp"

namespace quadrille {

/// Makes the geometry of a shape from its kind, and from its dimensions or its vertices and faces,
/// which must make such a shape.
void set_geometry(CollisionShape& shape);

}  // namespace quadrille
