#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `config`, which prints the settings of all programs.
void add_config_command(CLI::App& app);

}  // namespace quadrille
