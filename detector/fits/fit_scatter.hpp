#pragma once

#include <optional>

#include "fits/scatter.hpp"
#include "fits/type_design.hpp"

namespace quadrille {

/// Points lie on a surface to rounding if the mean squared misfit is less: 3e-8 of the extent,
/// while rounding of the sums leaves 2e-16.
inline constexpr double kExactMisfit = 1e-15;

/// The mean squared distance in Taubin's approximation, with the weighted tangent constraints that
/// fit_design() minimises.
double mean_misfit(const Scatter& scatter, const Quadric& Q, double weight);

/// Computes fit_design() from sums that are already known.
std::optional<Quadric> fit_design(const Scatter& scatter, const Design& B, double weight);

}  // namespace quadrille
