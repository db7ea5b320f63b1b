#include "lab/bench/frames.hpp"

#include <map>

namespace quadrille::bench {
namespace {

using Work = std::function<void(const scoring::Frame&, int family)>;

void for_each_cloud(const FrameOptions& options, const Work& work) {
  std::map<std::string, int> families;
  double done = 0.0;
  for (const std::string& path : options.clouds) {
    const scoring::Frame frame = scoring::read_frame(path);
    const int next = static_cast<int>(families.size());
    work(frame, families.emplace(frame.family, next).first->second);
    options.progress(++done / static_cast<double>(options.clouds.size()));
  }
}

void for_each_scene(const FrameOptions& options, const Work& work) {
  double done = 0.0;
  for (int family = 0; family < static_cast<int>(options.families.size()); ++family) {
    for (int k = 0; k < options.scenes; ++k) {
      const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(k);
      work(scoring::frame_of(scene::make_scene({options.families[family], seed})), family);
      options.progress(++done / (options.scenes * static_cast<double>(options.families.size())));
    }
  }
}

}  // namespace

void for_each_frame(const FrameOptions& options, const Work& work) {
  if (options.clouds.empty()) {
    for_each_scene(options, work);
  } else {
    for_each_cloud(options, work);
  }
}

}  // namespace quadrille::bench
