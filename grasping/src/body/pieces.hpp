#pragma once

#include <vector>

#include "body/body.hpp"
#include "quadrille/grasping/collision_shape.hpp"

namespace quadrille {

/// Convex shapes whose union holds the body: what a hand must stay out of.
std::vector<CollisionShape> make_pieces(const Body& body);

}  // namespace quadrille
