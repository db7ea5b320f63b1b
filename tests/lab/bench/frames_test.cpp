#include "lab/bench/frames.hpp"

#include "lab/scene/scene_files.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

namespace quadrille::bench {
namespace {

/// The names of the frames with the places of their families, and the shares that were told.
struct Seen {
  std::vector<std::string> names;
  std::vector<int> families;
  std::vector<double> shares;
};

Seen seen_of(FrameOptions options) {
  Seen seen;
  options.progress = [&](double share) { seen.shares.push_back(share); };
  for_each_frame(options, [&](const scoring::Frame& frame, int family) {
    seen.names.push_back(frame.name);
    seen.families.push_back(family);
  });
  return seen;
}

TEST_CASE("generated frames come family by family, from the first seed on", "[bench][frames]") {
  FrameOptions options;
  options.families = {scene::Family::kMedium, scene::Family::kEasy};
  options.scenes = 2;
  options.seed = 7;
  const Seen seen = seen_of(options);
  CHECK(seen.names == std::vector<std::string>{"medium 7", "medium 8", "easy 7", "easy 8"});
  CHECK(seen.families == std::vector<int>{0, 0, 1, 1});
  CHECK(seen.shares == std::vector<double>{0.25, 0.5, 0.75, 1.0});
}

TEST_CASE("frames from files come as they are named, their families by the first of each",
          "[bench][frames]") {
  const test::TempFolder folder;
  FrameOptions options;
  for (const auto family : {scene::Family::kMedium, scene::Family::kEasy}) {
    options.clouds.push_back(folder.path(std::to_string(static_cast<int>(family)) + ".ply"));
    write_scene(options.clouds.back(), scene::make_scene({family, 1000}), true);
  }
  options.clouds.push_back(options.clouds.front());
  const Seen seen = seen_of(options);
  CHECK(seen.names == options.clouds);
  CHECK(seen.families == std::vector<int>{0, 1, 0});
  CHECK(seen.shares.back() == 1.0);
}

}  // namespace
}  // namespace quadrille::bench
