#pragma once

#include <string>
#include <vector>

namespace quadrille::io {

/// A gripper file that is built into the programs.
struct GripperText {
  std::string name, toml;
};

/// Returns the files of tools/grippers, in the order of their names.
std::vector<GripperText> gripper_texts();

}  // namespace quadrille::io
