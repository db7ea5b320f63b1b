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
/// that type: coplanar points only determine a plane.

/// Fits a plane to at least 3 points.
std::optional<Quadric> fit_plane(const OrientedPointsd& points,
                                 const SimpleTypeOptions& options = {});
/// Fits a sphere to at least 2 oriented points.
std::optional<Quadric> fit_sphere(const OrientedPointsd& points,
                                  const SimpleTypeOptions& options = {});
/// Fits a spheroid to at least 4 oriented points: the axis from the normal lines, the rest by a
/// linear fit.
std::optional<Quadric> fit_spheroid(const OrientedPointsd& points,
                                    const SimpleTypeOptions& options = {});
/// Fits a circular cylinder to at least 2 oriented points: the axis orthogonal to the normals, the
/// rest by a linear fit.
std::optional<Quadric> fit_cylinder(const OrientedPointsd& points,
                                    const SimpleTypeOptions& options = {});
/// Fits a circular cone to at least 3 oriented points: the apex from all tangent planes, the axis
/// at a constant angle to the normals, the rest by a linear fit.
std::optional<Quadric> fit_cone(const OrientedPointsd& points,
                                const SimpleTypeOptions& options = {});

}  // namespace quadrille
