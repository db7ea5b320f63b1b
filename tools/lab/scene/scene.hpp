#pragma once

#include <cstdint>

#include "lab/scene/camera.hpp"
#include "lab/scene/family.hpp"
#include "lab/scene/layout.hpp"
#include "lab/scene/render.hpp"
#include "lab/scene/sensor.hpp"

namespace quadrille::scene {

/// The options that determine a scene.
struct SceneOptions {
  Family family = Family::kEasy;
  std::uint64_t seed = 0;
  int width = 640, height = 480;
};

/// A depth camera's view of a table with quadrics on it, with its full ground truth.
struct Scene {
  SceneOptions options;
  Camera camera;
  Layout layout;
  Rendering ideal;
  View view;
};

/// Makes a scene; the same options give the same scene.
Scene make_scene(const SceneOptions& options);

/// These are the steps of make_scene(), for several pictures of a scene: the bodies and where the
/// camera stands, the random numbers of the sensor, and a picture, which takes new ones of these.
Layout make_layout(const SceneOptions& options);
Random sensor_random(const SceneOptions& options);
Scene take_picture(const SceneOptions& options, const Layout& layout, Random* random);

/// Returns the number of curved surfaces in a scene.
int count_quadrics(const Scene& scene);

}  // namespace quadrille::scene
