#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `merge`: puts the results of detectors that share a stream into order.
void add_merge_command(CLI::App& app);

}  // namespace quadrille
