#pragma once

#include <cstdint>

#include "lab/scene/camera.hpp"
#include "lab/scene/family.hpp"
#include "lab/scene/layout.hpp"
#include "lab/scene/render.hpp"
#include "lab/scene/sensor.hpp"

namespace quadrille::scene {

/// What fixes a scene.
struct SceneOptions {
  Family family = Family::kEasy;
  std::uint64_t seed = 0;
  int width = 640, height = 480;
};

/// A depth camera's view of a table with quadrics on it, and all that is true of it.
struct Scene {
  SceneOptions options;
  Camera camera;
  Layout layout;
  Rendering ideal;
  View view;
};

/// The same options give the same scene.
Scene make_scene(const SceneOptions& options);

/// Curved surfaces of a scene.
int count_quadrics(const Scene& scene);

}  // namespace quadrille::scene
