#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `scene OUT.ply`, which renders a depth-camera scene with its ground truth.
void add_scene_command(CLI::App& app);

}  // namespace quadrille
