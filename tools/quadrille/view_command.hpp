#pragma once

#include <CLI/App.hpp>

namespace quadrille {

/// Adds `view`: shows clouds, quadrics and grasps in the browser, of a log or live.
void add_view_command(CLI::App& app);

}  // namespace quadrille
