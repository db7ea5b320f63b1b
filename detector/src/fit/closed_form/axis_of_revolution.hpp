#pragma once

#include <Eigen/Core>
#include <optional>

#include "fit/oriented_points.hpp"

namespace quadrille {

/// The line that meets all normal lines best: the axis of a surface of revolution.
struct AxisOfRevolution {
  /// Unit direction, and the point nearest to the origin.
  Eigen::Vector3d direction, foot;
  /// The least sum of squared moments, then those of the two other directions, in ascending order.
  Eigen::Vector3d misfits;
};

/// Fits the axis by a linear line complex (H. Pottmann, J. Wallner, "Computational line geometry",
/// 2001).
/// @param lines  Σ h hᵀ over the normal lines h = (x × n, n)
/// @param ridge  added to Σ n nᵀ in shares of its trace, so that an axis along which the surface
///   can slide has its foot next to the origin; 0 for none
/// @return nullopt if the normals do not determine a finite line
std::optional<AxisOfRevolution> axis_of_revolution(const Eigen::Matrix<double, 6, 6>& lines,
                                                   double ridge);

/// Fits the axis to points.
std::optional<AxisOfRevolution> axis_of_revolution(const OrientedPointsd& points, double ridge);

}  // namespace quadrille
