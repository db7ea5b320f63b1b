#pragma once

#include <CLI/App.hpp>

namespace quadrille {

/// Adds `view`, which shows clouds, quadrics and grasps in the browser, from a log or live.
void add_view_command(CLI::App& app);

}  // namespace quadrille
