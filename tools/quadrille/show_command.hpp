#pragma once

#include <CLI/App.hpp>

namespace quadrille {

/// Adds `show LOG`, which prints the quadrics and grasps that were published into an LCM log.
void add_show_command(CLI::App& app);

}  // namespace quadrille
