#pragma once

#include <optional>

#include "fits/scatter.hpp"
#include "fits/type_design.hpp"

namespace quadrille {

/// Computes fit_design() from sums that are already known.
std::optional<Quadric> fit_design(const Scatter& scatter, const Design& B, double weight);

}  // namespace quadrille
