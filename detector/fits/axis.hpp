#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

/// The direction orthogonal to all normals (least eigenvector of Σ n nᵀ), which is a cylinder's
/// axis; nullopt if all normals are parallel.
std::optional<Eigen::Vector3d> direction_across_normals(const OrientedPointsd& points);

/// The axis of a circular cone with a known apex: the direction at a constant angle to the normals
/// of one nappe. Unlike the detector's initial_cone(), this takes points on both nappes. Nullopt if
/// the normals do not determine the direction.
std::optional<Eigen::Vector3d> cone_axis(const OrientedPointsd& points,
                                         const Eigen::Vector3d& apex);

/// The direction found by the detector's axis_of_revolution(); nullopt if it is not unique.
std::optional<Eigen::Vector3d> direction_of_revolution(const OrientedPointsd& points);

/// The point common to all tangent planes, which is a cone's apex; nullopt if they share a line.
std::optional<Eigen::Vector3d> common_point_of_planes(const OrientedPointsd& points);

}  // namespace quadrille
