#pragma once

#include <optional>
#include <vector>

#include "fits/normalise.hpp"

namespace quadrille {

/// The direction orthogonal to all normals (least eigenvector of Σ n nᵀ), which is a cylinder's
/// axis; nullopt if all normals are parallel.
std::optional<Eigen::Vector3d> direction_across_normals(const OrientedPointsd& points);

/// The directions that a circular cone with a known apex may have: at a constant angle to the
/// normals of one nappe, where the normals are taken as outward, as inward, or as all of one nappe.
/// Unlike the detector's initial_cone(), this takes points on both nappes. Three normals are at a
/// constant angle to an axis in each case, so only the points tell which direction is right.
/// @return none if the normals do not determine them
std::vector<Eigen::Vector3d> cone_axes(const OrientedPointsd& points, const Eigen::Vector3d& apex);

/// The directions that the axis of a surface of revolution may have: the one found by the
/// detector's axis_of_revolution(), or from four points those of the two lines that meet four
/// lines.
/// @return none if the normals do not determine them, as those of a sphere
std::vector<Eigen::Vector3d> directions_of_revolution(const OrientedPointsd& points);

/// The point common to all tangent planes, which is a cone's apex; nullopt if they nearly share a
/// line.
std::optional<Eigen::Vector3d> common_point_of_planes(const OrientedPointsd& points);

}  // namespace quadrille
