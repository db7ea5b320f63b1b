#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "lab/confidence/observe.hpp"

using namespace quadrille;

namespace {

constexpr scene::Family kFamilies[] = {scene::Family::kEasy, scene::Family::kMedium,
                                       scene::Family::kHard, scene::Family::kTabletop};

void print_header() {
  fmt::print("scene,right,log_prior");
  for (const ConfidenceWeight& row : kConfidenceWeights) fmt::print(",{}", row.term);
  fmt::print("\n");
}

void print_rows(const scoring::Frame& frame) {
  for (const auto& observation : confidence_training::observe(frame)) {
    fmt::print("{},{:d},{}", frame.name, observation.right, observation.log_prior);
    for (const double term : observation.terms) fmt::print(",{}", term);
    fmt::print("\n");
  }
}

}  // namespace

// Prints the evidence for each curved surface that the detector considers, and whether it is
// right, as CSV: of generated scenes, or of scenes in files as `quadrille scene --labels` writes
// them.
int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: quadrille_confidence SCENES [SEED] | SCENE.ply…\n");
    return 2;
  }
  try {
    print_header();
    if (std::string(argv[1]).ends_with(".ply")) {
      for (int k = 1; k < argc; ++k) print_rows(scoring::read_frame(argv[k]));
      return 0;
    }
    const int scenes = std::stoi(argv[1]);
    const std::uint64_t seed = argc > 2 ? std::stoull(argv[2]) : 1;
    for (int k = 0; k < scenes; ++k) {
      const scene::Family family = kFamilies[static_cast<std::size_t>(k) % std::size(kFamilies)];
      print_rows(scoring::frame_of(
          scene::make_scene({family, 1000 * seed + static_cast<std::uint64_t>(k)})));
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "quadrille_confidence: {}\n", error.what());
    return 1;
  }
  return 0;
}
