#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `log OUT.lcm INPUT…`, which writes clouds as an LCM log.
void add_log_command(CLI::App& app);

}  // namespace quadrille
