#pragma once

#include <string>
#include <vector>

#include "io/json/json.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/solid_shape.hpp"

namespace quadrille::io {

/// Returns a shape as read_shapes() reads it.
Json to_json(const SolidShape& shape);

/// Reads the shapes of a JSON file, an object with the array "shapes" as `quadrille plan --json`
/// writes it: of each its kind, its pose, and dimensions, or vertices and faces, in metres.
/// @throws FileError if a shape is missing something or makes no sense
std::vector<SolidShape> read_shapes(const std::string& path);

/// Reads a file of the robot's own shapes: "shapes" as above, and "padding" [m], which may be left
/// out.
/// @throws FileError as read_shapes() does
RobotShapes read_robot(const std::string& path);

}  // namespace quadrille::io
