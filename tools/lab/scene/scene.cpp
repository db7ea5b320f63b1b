#include "lab/scene/scene.hpp"

#include <algorithm>

namespace quadrille::scene {

Scene make_scene(const SceneOptions& options) {
  const FamilyTraits& traits = traits_of(options.family);
  const auto family = static_cast<std::uint64_t>(options.family);
  // Bodies and pixels have separate streams, so that the same seed shows the same bodies in any
  // image size.
  Random bodies(options.seed, 2 * family), pixels(options.seed, 2 * family + 1);
  Scene scene;
  scene.options = options;
  scene.camera = Camera::of_size(options.width, options.height);
  scene.layout = find_layout(traits, &bodies);
  scene.ideal = render(scene.camera, scene.layout.bodies, scene.layout.X_CW);
  scene.view = observe(scene.camera, scene.ideal, traits, &pixels);
  return scene;
}

int count_quadrics(const Scene& scene) {
  std::ptrdiff_t count = 0;
  for (const Body& body : scene.layout.bodies) {
    count += std::count_if(body.surfaces.begin(), body.surfaces.end(),
                           [](const Surface& surface) { return surface.curved; });
  }
  return static_cast<int>(count);
}

}  // namespace quadrille::scene
