#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `study grasps`, which finds, plans, judges and tries grasps over many scenes and writes one
/// row per grasp and one per scene; and `study summary`, which sums up the tables of such studies.
void add_study_command(CLI::App& app);

}  // namespace quadrille
