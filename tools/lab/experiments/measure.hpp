#pragma once

#include <functional>
#include <vector>

namespace quadrille::experiments {

/// Returns the processor time of a call on this thread [µs], which other work on the machine hardly
/// affects.
double microseconds(const std::function<void()>& call);

/// Returns the value below which this share of the values lies, interpolated linearly; sorts a
/// copy.
/// @throws std::invalid_argument if there are no values
double quantile(std::vector<double> values, double share);

}  // namespace quadrille::experiments
