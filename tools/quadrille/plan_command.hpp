#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `plan INPUT --gripper NAME|FILE`, which detects quadrics and plans grasps on them.
void add_plan_command(CLI::App& app);

}  // namespace quadrille
