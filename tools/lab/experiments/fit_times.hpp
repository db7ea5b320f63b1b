#pragma once

#include "lab/experiments/experiment.hpp"

namespace quadrille::experiments {

/// Time of every contender against the number of points, median over repetitions (paper,
/// figure 5E): a line a contender, µs over points.
std::vector<Series> fit_times(const Settings& settings);

}  // namespace quadrille::experiments
