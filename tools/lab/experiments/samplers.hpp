#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/experiments/neighbourhood.hpp"

namespace quadrille::experiments {

/// Least cosine between a voter's or an inlier's normal and a hypothesis's gradient.
inline constexpr double kSamplerCosine = 0.85;
/// The sampler that solves for the gradients' lengths; the detector uses a common scale by default.
inline constexpr const char* kThreeName = "3 points, vote, consistency test";

/// Turns random points of a neighbourhood into hypotheses.
struct Sampler {
  std::string name;
  std::function<void(const Neighbourhood&, const OrientedPointsf& voters, RandomStream&,
                     std::vector<Quadric>*)>
      draw;
};

/// Returns the paper's ways of drawing a hypothesis, with bases of two, three, four and nine
/// points.
std::vector<Sampler> all_samplers();

}  // namespace quadrille::experiments
