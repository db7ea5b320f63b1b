#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `scene OUT.ply`: renders a depth-camera scene with its truth.
void add_scene_command(CLI::App& app);

}  // namespace quadrille
