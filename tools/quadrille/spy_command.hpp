#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `spy`, which becomes lcm-spy with knowledge of our messages.
void add_spy_command(CLI::App& app);

}  // namespace quadrille
