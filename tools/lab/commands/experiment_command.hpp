#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `experiment [NAME]`, which runs an experiment of the paper and writes NAME.md, NAME.csv and
/// NAME.svg; without a name it lists the experiments.
void add_experiment_command(CLI::App& app);

}  // namespace quadrille
