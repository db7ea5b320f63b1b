#pragma once

#include <vector>

#include "body/body.hpp"
#include "quadrille/grasping/collision_shape.hpp"

namespace quadrille {

/// Makes convex shapes whose union encloses the body: the space that a hand must stay out of.
std::vector<CollisionShape> make_pieces(const Body& body);

}  // namespace quadrille
