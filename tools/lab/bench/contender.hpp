#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/settings/config.hpp"
#include "lab/scoring/frame.hpp"
#include "lab/scoring/score.hpp"

namespace quadrille::bench {

using scoring::Found;
using scoring::Frame;
using scoring::FrameScore;

/// The result of a contender on one frame, with the time from the decoded cloud to the findings.
struct Outcome {
  std::vector<Found> findings;
  double wall_ms = 0.0, cpu_ms = 0.0;
};

/// One detector with its settings. All contenders use one thread.
struct Contender {
  /// Name for tables and for selection.
  std::string name;
  /// Description in one line.
  std::string about;
  /// The only type that the contender looks for; empty if it looks for all that it knows.
  std::string only;
  /// Why the contender cannot run here; empty if it can.
  std::string absent;
  std::function<Outcome(const Frame&)> run;
  /// True if the contender is told which points belong to each body with a curved surface, and gets
  /// no others.
  bool given_objects = false;
};

/// Returns Quadrille and its variants, plain baselines, and the peers, including absent ones.
/// @param programs  folder of the peers' programs
/// @param config    settings of Quadrille and its variants
std::vector<Contender> all_contenders(const std::string& programs,
                                      const io::DetectorConfig& config = {});

}  // namespace quadrille::bench
