#pragma once

#include <string>
#include <vector>

#include "quadrille/grasping/gripper.hpp"

namespace quadrille::io {

/// Reads a gripper from a TOML file whose keys are the fields of Gripper; all sizes in metres,
/// vectors as arrays. `name`, `link_length`, `link_angle` and `tcp` are optional, every other key
/// is required.
/// @throws FileError naming line and key, or what contradicts what
Gripper read_gripper(const std::string& path);

/// A gripper by built-in name, or from a file if the text ends in ".toml".
/// @throws FileError as above
/// @throws std::invalid_argument if there is no gripper of that name; lists the names
Gripper load_gripper(const std::string& name_or_path);

/// All that a file says of a gripper, as read_gripper() reads it: equal texts are equal grippers.
std::string to_toml(const Gripper& gripper);

/// The built-in grippers: those of tools/grippers, in the order of their names.
std::vector<std::string> gripper_names();

/// The file of a built-in gripper as it stands in tools/grippers, which read_gripper() reads.
/// @throws std::invalid_argument if there is none of that name; lists the names
std::string gripper_toml(const std::string& name);

}  // namespace quadrille::io
