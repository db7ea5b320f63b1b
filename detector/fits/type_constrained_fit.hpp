#pragma once

#include <optional>

#include "fits/normalise.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// Fits the best quadric of a given type, after the catalogue of type-specific direct fits by J.
/// Andrews and C. H. Séquin, "Type-constrained direct fitting of quadric surfaces", Computer-Aided
/// Design and Applications 2013, with its two strategies:
/// - cones, cylinders, paraboloids and similar types: axis or apex first, then a linear fit in the
///   design of the type;
/// - ellipsoids, hyperboloids and central cylinders, which are open sets: Taubin's fit, and if that
///   is of another type, the first quadric of the right type on the line from it to an anchor. The
///   anchor is a fit of the type whose quadratic part is fixed (all semi-axes equal).
/// The article's own anchors for hyperboloids differ.
/// @param points  at least 9
/// @return nullopt if the points are too few or do not determine such a surface
/// @throws std::invalid_argument for imaginary types
std::optional<Quadric> fit_of_type(const OrientedPointsd& points, QuadricType type);

}  // namespace quadrille
