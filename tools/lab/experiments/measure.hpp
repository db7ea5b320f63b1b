#pragma once

#include <functional>
#include <vector>

namespace quadrille::experiments {

/// Processor time of a call on this thread [µs]: what else the machine does hardly matters.
double microseconds(const std::function<void()>& call);

/// The value below which the share of the values lies, linear between two; sorts a copy.
/// @throws std::invalid_argument if there are no values
double quantile(std::vector<double> values, double share);

}  // namespace quadrille::experiments
