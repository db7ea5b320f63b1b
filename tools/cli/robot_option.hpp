#pragma once

#include <string>

#include "quadrille/detector/robot_shapes.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// Adds --robot, a file that is read into the robot's own shapes; they must outlive the app.
/// @param frame  the frame of the shapes, for the description
void add_robot_option(CLI::App& app, RobotShapes& robot, const std::string& frame);

}  // namespace quadrille
