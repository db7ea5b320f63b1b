#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/scoring/frame.hpp"

namespace quadrille::bench {

/// Which frames are worked on.
struct FrameOptions {
  /// Families of generated scenes, with so many scenes of each; the first has this seed.
  std::vector<scene::Family> families = {scene::Family::kEasy, scene::Family::kMedium,
                                         scene::Family::kHard};
  int scenes = 20;
  std::uint64_t seed = 1000;
  /// Clouds with their truth, instead of generated ones.
  std::vector<std::string> clouds;
  /// Told the share that is done, 0 to 1.
  std::function<void(double)> progress = [](double) {};
};

/// Has each frame worked on, one at a time.
/// @param work  gets the frame and the place of its family among all, in the order of the options
///              or of the first cloud of each
/// @throws std::runtime_error if a cloud cannot be read
void for_each_frame(const FrameOptions& options,
                    const std::function<void(const scoring::Frame&, int family)>& work);

}  // namespace quadrille::bench
