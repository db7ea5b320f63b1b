#pragma once

#include <optional>

#include "fits/scatter.hpp"
#include "fits/type_design.hpp"

namespace quadrille {

/// fit_design() on sums that are already taken.
std::optional<Quadric> fit_design(const Scatter& scatter, const Design& B, double weight);

}  // namespace quadrille
