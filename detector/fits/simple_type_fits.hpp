#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct SimpleTypeOptions {
  /// Weight of a tangent constraint against a point, in normalised coordinates.
  double weight = 0.3;
};

/// Fits of one type each, by the redesigned matrix A B of its type (type_design.hpp). They give
/// nullopt where the points are too few, coincide, lie on a line, or do not determine a surface of
/// that very type: coplanar points have a plane and nothing else.

/// The plane of 3 points or more.
std::optional<Quadric> fit_plane(const OrientedPointsd& points,
                                 const SimpleTypeOptions& options = {});
/// The sphere of 2 oriented points or more.
std::optional<Quadric> fit_sphere(const OrientedPointsd& points,
                                  const SimpleTypeOptions& options = {});
/// The spheroid of 4 oriented points or more: axis from the normal lines, then linear.
std::optional<Quadric> fit_spheroid(const OrientedPointsd& points,
                                    const SimpleTypeOptions& options = {});
/// The circular cylinder of 2 oriented points or more: axis across the normals, then linear.
std::optional<Quadric> fit_cylinder(const OrientedPointsd& points,
                                    const SimpleTypeOptions& options = {});
/// The circular cone of 3 oriented points or more: apex in all tangent planes, axis at a constant
/// angle to the normals, then linear.
std::optional<Quadric> fit_cone(const OrientedPointsd& points,
                                const SimpleTypeOptions& options = {});

}  // namespace quadrille
