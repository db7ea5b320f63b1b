#pragma once

#include <string>
#include <vector>

#include "lab/bench/frames.hpp"
#include "quadrille/detector/options.hpp"

namespace quadrille::bench {

/// How far the detector comes with the surfaces of a family of scenes. By the rule of
/// scoring::score(), a quadric may be a surface; each surface is counted once, at the furthest
/// stage that any quadric of its own reaches.
struct StageCounts {
  std::string family;
  int scenes = 0;
  /// Curved surfaces that had to be found: the sum of the six below.
  int wanted = 0;
  /// No quadric that is tried is the surface: the search missed it, or surfaces that were accepted
  /// hold all samples of its candidates.
  int no_hypothesis = 0;
  /// Surfaces that were accepted hold most samples of each candidate.
  int claimed = 0;
  /// The candidate's own fit was refused.
  int first_look = 0;
  /// There is no better fit, or it is refused before its confidence counts, or it is another
  /// surface.
  int fit = 0;
  /// There is too little confidence in the better fit.
  int confidence = 0;
  /// The better fit was accepted.
  int accepted = 0;
  /// Surfaces among the detections, which are joined and measured from what was accepted.
  int detected = 0;
  /// Better fits that were accepted, but are no surface, neither curved nor flat.
  int wrong = 0;

  /// Adds all numbers.
  StageCounts& operator+=(const StageCounts& other);
};

/// Follows the surfaces of one frame.
/// @throws std::invalid_argument if an option is out of range
StageCounts follow_stages(const scoring::Frame& frame, const DetectorOptions& options);

/// Follows the surfaces of all frames.
/// @return by family
/// @throws std::runtime_error if a cloud cannot be read
std::vector<StageCounts> count_stages(const FrameOptions& frames,
                                      const DetectorOptions& options = {});

}  // namespace quadrille::bench
