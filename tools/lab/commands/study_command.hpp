#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `study grasps`: finds, plans, judges and tries grasps over many scenes, one row a grasp
/// and one a scene; and `study summary`: sums up the tables of such studies.
void add_study_command(CLI::App& app);

}  // namespace quadrille
