#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `doctor`, which tells whether clouds will arrive over LCM on this machine, and what to type
/// if not.
void add_doctor_command(CLI::App& app);

}  // namespace quadrille
