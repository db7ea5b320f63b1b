#pragma once

#include <optional>

#include "fits/oriented_points.hpp"

namespace quadrille {

/// The direction across all normals (least eigenvector of Σ n nᵀ): a cylinder's axis. nullopt if
/// all normals are parallel.
std::optional<Eigen::Vector3d> direction_across_normals(const OrientedPoints& points);

/// The axis of a circular cone with a known apex: the direction at a constant angle to the normals
/// of one nappe. nullopt if the normals end in less than a plane.
std::optional<Eigen::Vector3d> cone_axis(const OrientedPoints& points, const Eigen::Vector3d& apex);

/// The direction of the line that all normal lines meet (linear line complex: Pottmann, Wallner,
/// "Computational line geometry", 2001): a surface of revolution's axis. nullopt if there are more.
std::optional<Eigen::Vector3d> direction_of_revolution(const OrientedPoints& points);

/// The point that all tangent planes share: a cone's apex. nullopt if they share a line.
std::optional<Eigen::Vector3d> common_point_of_planes(const OrientedPoints& points);

}  // namespace quadrille
