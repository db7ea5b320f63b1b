#include "lab/scene/scene.hpp"

#include <algorithm>

#include "lab/scene/bin.hpp"

namespace quadrille::scene {
namespace {

/// Returns the number of the first of a family's two streams of random numbers. Bodies and pixels
/// have separate streams, so that the same seed shows the same bodies in any image size.
std::uint64_t stream_of(Family family) { return 2 * static_cast<std::uint64_t>(family); }

}  // namespace

Scene make_scene(const SceneOptions& options) {
  Random random = sensor_random(options);
  return take_picture(options, make_layout(options), &random);
}

Layout make_layout(const SceneOptions& options) {
  Random random(options.seed, stream_of(options.family));
  if (options.family == Family::kBin) return fill_bin({}, &random);
  return find_layout(traits_of(options.family), &random);
}

Random sensor_random(const SceneOptions& options) {
  return Random(options.seed, stream_of(options.family) + 1);
}

Scene take_picture(const SceneOptions& options, const Layout& layout, Random* random) {
  Scene scene;
  scene.options = options;
  scene.camera = Camera::of_size(options.width, options.height);
  scene.layout = layout;
  scene.ideal = render(scene.camera, layout.bodies, layout.X_CW);
  scene.view = observe(scene.camera, scene.ideal, traits_of(options.family), random);
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
