#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `gripper`, which prints a built-in gripper as a file, or lists them all.
void add_gripper_command(CLI::App& app);

}  // namespace quadrille
