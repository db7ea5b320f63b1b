#pragma once

#include <CLI/App.hpp>

namespace quadrille {

/// Adds `detect INPUT…`: finds the quadrics of clouds.
void add_detect_command(CLI::App& app);

}  // namespace quadrille
