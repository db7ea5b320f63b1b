#pragma once

#include <string>
#include <vector>

#include "lab/bench/frames.hpp"
#include "quadrille/detector/options.hpp"

namespace quadrille::bench {

/// How far the detector gets with the surfaces of a family of scenes. The rule of scoring::score()
/// decides which surface a quadric is. Each surface is counted once, at the furthest stage that any
/// of its quadrics reaches.
struct StageCounts {
  std::string family;
  int scenes = 0;
  /// Number of curved surfaces that had to be found: the sum of the six counts below.
  int wanted = 0;
  /// No quadric that was tried is the surface: the search missed it, or accepted surfaces claim all
  /// samples of its candidates.
  int no_hypothesis = 0;
  /// Accepted surfaces claim most samples of each candidate.
  int claimed = 0;
  /// The candidate's own fit was refused.
  int first_look = 0;
  /// There is no better fit, or it is refused before its confidence is tested, or it is another
  /// surface.
  int fit = 0;
  /// The confidence in the better fit is too low.
  int confidence = 0;
  /// The better fit was accepted.
  int accepted = 0;
  /// Number of surfaces among the detections, which are joined and measured from accepted fits.
  int detected = 0;
  /// Number of accepted fits that are no surface, neither curved nor flat.
  int wrong = 0;

  /// Adds all counts.
  StageCounts& operator+=(const StageCounts& other);
};

/// Counts the surfaces of one frame.
/// @throws std::invalid_argument if an option is out of range
StageCounts follow_stages(const scoring::Frame& frame, const DetectorOptions& options);

/// Counts the surfaces of all frames.
/// @return the counts by family
/// @throws std::runtime_error if a cloud cannot be read
std::vector<StageCounts> count_stages(const FrameOptions& frames,
                                      const DetectorOptions& options = {});

}  // namespace quadrille::bench
