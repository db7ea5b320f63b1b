#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `gripper`: prints a built-in hand as a file, or lists them all.
void add_gripper_command(CLI::App& app);

}  // namespace quadrille
