#pragma once

#include "lab/experiments/experiment.hpp"

namespace quadrille::experiments {

/// Measures the time of every contender against the number of points, median over repetitions
/// (paper, figure 5E): one line per contender, µs over points.
std::vector<Series> fit_times(const Settings& settings);

}  // namespace quadrille::experiments
