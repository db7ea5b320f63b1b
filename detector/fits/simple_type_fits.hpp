#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct SimpleTypeOptions {
  /// Weight of a tangent constraint relative to a point, in normalised coordinates.
  double weight = 0.3;
};

/// Fits of one type each by the type's redesigned matrix A B (type_design.hpp). They return nullopt
/// if the points are too few, coincide, lie on a line, or do not determine a surface of exactly
/// that type: coplanar points only determine a plane. They also do so if rounding could move the
/// surface by about a millionth of the points' extent, or if two surfaces fit all points exactly.

/// Fits a plane to at least 3 points.
std::optional<Quadric> fit_plane(const OrientedPointsd& points,
                                 const SimpleTypeOptions& options = {});
/// Fits a sphere to at least 2 oriented points.
std::optional<Quadric> fit_sphere(const OrientedPointsd& points,
                                  const SimpleTypeOptions& options = {});
/// Fits a spheroid to at least 4 oriented points: the axis from the normal lines, the rest by a
/// linear fit. Two lines meet the normal lines of 4 points; the spheroid that fits the points
/// better decides.
std::optional<Quadric> fit_spheroid(const OrientedPointsd& points,
                                    const SimpleTypeOptions& options = {});
/// Fits a circular cylinder to at least 2 oriented points: the axis orthogonal to the normals, the
/// rest by a linear fit.
std::optional<Quadric> fit_cylinder(const OrientedPointsd& points,
                                    const SimpleTypeOptions& options = {});
/// Fits a circular cone to at least 3 oriented points on one nappe or on both: the apex from all
/// tangent planes, the axis at a constant angle to the normals, the rest by a linear fit. Of the
/// axes for points on one nappe and on both, the one with the least residual is taken.
std::optional<Quadric> fit_cone(const OrientedPointsd& points,
                                const SimpleTypeOptions& options = {});

}  // namespace quadrille
