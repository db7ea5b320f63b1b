#pragma once

#include <optional>

#include "fits/normalise.hpp"
#include "quadrille/detector/quadric_type.hpp"

namespace quadrille {

/// The best quadric of a type known beforehand, after the catalogue of type-specific direct fits by
/// J. Andrews and C. H. Séquin, "Type-constrained direct fitting of quadric surfaces",
/// Computer-Aided Design and Applications 2013, with its two strategies:
/// - cones, cylinders, paraboloids and their like: axis or apex first, then a linear fit in the
///   design of the type;
/// - ellipsoids, hyperboloids and the central cylinders, which are open sets: Taubin's fit, and if
///   that is of another type the first of the right one on the line from it to an anchor, a fit of
///   fixed quadratic part (all semi-axes equal) of the type.
/// The article's own anchors for hyperboloids differ.
/// @param points  9 or more
/// @return nullopt if the points are too few or do not determine such a surface
/// @throws std::invalid_argument for imaginary types
std::optional<Quadric> fit_of_type(const OrientedPointsd& points, QuadricType type);

}  // namespace quadrille
