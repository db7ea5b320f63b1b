#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `experiment [NAME]`: runs an experiment of the paper and writes NAME.md, NAME.csv and
/// NAME.svg; without a name lists them.
void add_experiment_command(CLI::App& app);

}  // namespace quadrille
