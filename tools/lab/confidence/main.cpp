#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string_view>
#include <vector>

#include "lab/confidence/observe.hpp"

using namespace quadrille;

namespace {

// A confidence that no surface reaches.
constexpr double kCertain = 0.9999;

void print_header() {
  fmt::print("scene,kind,right");
  for (const std::string_view term : kConfidenceTerms) fmt::print(",{}", term);
  fmt::print("\n");
}

void print_rows(const scoring::Frame& frame, const DetectorOptions& options) {
  for (const auto& observation : confidence_training::observe(frame, options)) {
    fmt::print("{},{},{:d}", frame.name, observation.flat ? "flat" : "curved", observation.right);
    for (const double term : observation.terms) fmt::print(",{:.7g}", term);
    fmt::print("\n");
  }
}

}  // namespace

// Reads scenes with ground truth as `quadrille scene --labels` writes them. Prints as CSV the
// evidence for each surface that the detector weighs, and whether it is right. With --accept-none
// no candidate claims its samples, so that each is weighed as if nothing else had been found.
int main(int argc, char** argv) {
  std::vector<std::string_view> arguments(argv + 1, argv + argc);
  DetectorOptions options;
  if (!arguments.empty() && arguments.front() == "--accept-none") {
    options.aggregate.min_confidence = options.aggregate.min_confidence_early = kCertain;
    arguments.erase(arguments.begin());
  }
  if (arguments.empty()) {
    fmt::print(stderr, "usage: quadrille_confidence [--accept-none] SCENE.ply…\n");
    return 2;
  }
  print_header();
  try {
    for (const std::string_view path : arguments) {
      print_rows(scoring::read_frame(std::string(path)), options);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "quadrille_confidence: {}\n", error.what());
    return 1;
  }
  return 0;
}
