#include "lab/experiments/generated_scenes.hpp"

namespace quadrille::experiments {

void for_each_scene(const std::vector<scene::Family>& families, int scenes,
                    const Settings& settings,
                    const std::function<void(const scene::Scene&)>& work) {
  double done = 0.0;
  for (const scene::Family family : families) {
    for (int k = 0; k < scenes; ++k) {
      const std::uint64_t seed = settings.seed * 1000 + static_cast<std::uint64_t>(k);
      work(scene::make_scene({family, seed}));
      settings.progress(++done / (scenes * static_cast<double>(families.size())));
    }
  }
}

}  // namespace quadrille::experiments
