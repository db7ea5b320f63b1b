#pragma once

#include <string>
#include <vector>

#include "quadrille/grasping/gripper.hpp"

namespace quadrille::io {

/// Reads a gripper from a TOML file whose keys are the fields of Gripper; all sizes in metres,
/// vectors as arrays. `name`, `link_length`, `link_angle` and `tcp` are optional; every other key
/// is required.
/// @throws FileError naming line and key, or the contradiction
Gripper read_gripper(const std::string& path);

/// Returns a built-in gripper by name, or reads it from a file if the text ends in ".toml".
/// @throws FileError as read_gripper() does
/// @throws std::invalid_argument listing the names, if there is no gripper of that name
Gripper load_gripper(const std::string& name_or_path);

/// Returns the full description of a gripper in the form that read_gripper() reads; equal texts are
/// equal grippers.
std::string to_toml(const Gripper& gripper);

/// Returns the names of the built-in grippers, those of tools/grippers, in order.
std::vector<std::string> gripper_names();

/// Returns the file of a built-in gripper as it is in tools/grippers; read_gripper() can read it.
/// @throws std::invalid_argument listing the names, if there is none of that name
std::string gripper_toml(const std::string& name);

}  // namespace quadrille::io
