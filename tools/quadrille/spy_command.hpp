#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `spy`: becomes lcm-spy, which then knows our messages.
void add_spy_command(CLI::App& app);

}  // namespace quadrille
