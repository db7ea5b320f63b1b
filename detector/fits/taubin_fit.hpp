#pragma once

#include <optional>

#include "fits/oriented_points.hpp"

namespace quadrille {

/// Taubin's fit: least mean squared value under the constraint that the squared gradient has mean
/// 1, a generalised eigenvalue problem (G. Taubin, "Estimation of planar curves, surfaces, and
/// nonplanar space curves defined by implicit equations", PAMI 1991).
/// @param points  9 or more; normals only choose the gradient's side
/// @return nullopt if the points are too few, coplanar, or lie on another quadric as well
std::optional<Quadric> fit_taubin(const OrientedPoints& points);

}  // namespace quadrille
