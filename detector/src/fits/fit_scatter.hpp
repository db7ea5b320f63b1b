#pragma once

#include <optional>

#include "quadrille/detector/fits/type_design.hpp"
#include "scatter.hpp"

namespace quadrille {

/// fit_design() on sums that are already taken.
std::optional<Quadric> fit_design(const Scatter& scatter, const Design& B, double weight);

}  // namespace quadrille
