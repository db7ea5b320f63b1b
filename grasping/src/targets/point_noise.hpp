#pragma once

#include "base/cloud_runs.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Estimates the standard deviation of the cloud's points across a detected surface, from the
/// median of their first-order distances to the quadric [m]. It counts points within 15 mm of the
/// surface, so the result is at most 22 mm; 0 if there are none. Large clouds are sampled.
double point_noise(const Detection& detection, const CloudRuns& cloud);

}  // namespace quadrille
