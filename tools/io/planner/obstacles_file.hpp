#pragma once

#include <string>
#include <vector>

#include "quadrille/grasping/collision_shape.hpp"

namespace quadrille::io {

/// Reads the shapes of a JSON file, an object with the array "shapes" as `quadrille plan --json`
/// writes it: of each its kind, its pose, and dimensions, or vertices and faces, in metres.
/// @throws FileError if a shape is missing something or makes no sense
std::vector<CollisionShape> read_obstacles(const std::string& path);

}  // namespace quadrille::io
