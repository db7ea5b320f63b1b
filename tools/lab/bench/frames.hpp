#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/scoring/frame.hpp"

namespace quadrille::bench {

/// Selects the frames.
struct FrameOptions {
  /// Families of generated scenes, the number of scenes of each, and the seed of the first scene.
  std::vector<scene::Family> families = {scene::Family::kEasy, scene::Family::kMedium,
                                         scene::Family::kHard};
  int scenes = 20;
  std::uint64_t seed = 1000;
  /// Clouds with ground truth, used instead of generated scenes.
  std::vector<std::string> clouds;
  /// Called with the share of the work that is done, 0 to 1.
  std::function<void(double)> progress = [](double) {};
};

/// Calls `work` for each frame, one at a time.
/// @param work  receives the frame and the index of its family, in the order of the options or of
///              the first cloud of each family
/// @throws std::runtime_error if a cloud cannot be read
void for_each_frame(const FrameOptions& options,
                    const std::function<void(const scoring::Frame&, int family)>& work);

}  // namespace quadrille::bench
