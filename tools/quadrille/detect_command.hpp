#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `detect INPUT…`, which finds the quadrics of clouds.
void add_detect_command(CLI::App& app);

}  // namespace quadrille
