#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/scoring/frame.hpp"
#include "lab/scoring/score.hpp"

namespace quadrille::bench {

using scoring::Found;
using scoring::Frame;
using scoring::FrameScore;

/// What a contender made of a frame, with its time from the decoded cloud to the findings.
struct Outcome {
  std::vector<Found> findings;
  double wall_ms = 0.0, cpu_ms = 0.0;
};

/// One detector with its settings. All use one thread.
struct Contender {
  /// For tables, and to be chosen by.
  std::string name;
  /// One line on what it is.
  std::string about;
  /// The only type that it looks for; empty if it looks for all that it knows.
  std::string only;
  /// Why it cannot run here; empty if it can.
  std::string absent;
  std::function<Outcome(const Frame&)> run;
};

/// Quadrille and its variants, plain baselines, and the peers, also those that are absent.
/// @param programs  folder of the peers' programs
std::vector<Contender> all_contenders(const std::string& programs);

}  // namespace quadrille::bench
