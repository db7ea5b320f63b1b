#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `quadrille try` to the app.
void add_try_command(CLI::App& app);

}  // namespace quadrille
