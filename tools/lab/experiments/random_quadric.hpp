#pragma once

#include "base/random.hpp"
#include "fits/normalise.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::experiments {

/// Returns the curved type with this index, among those that experiments draw from; the commoner
/// types come first.
QuadricType curved_type(int index);
inline constexpr int kCurvedTypes = 12;

/// Returns a standard normal deviate (Box and Muller).
double gaussian(RandomStream& random);

/// Returns a unit vector, uniform over the sphere.
Eigen::Vector3d random_direction(RandomStream& random);

/// Returns a quadric of the type with random dimensions and orientation, about the origin, that
/// fills the unit ball or is cut by it.
Quadric random_quadric(QuadricType type, RandomStream& random);

/// Returns points of the quadric within the unit ball, uniform by area, with unit gradients as
/// normals: the intersections with isotropic random lines (Cauchy and Crofton).
/// @throws std::invalid_argument if hardly any line meets the quadric
OrientedPointsd sample(const Quadric& Q, Eigen::Index count, RandomStream& random);

/// Adds Gaussian noise to each coordinate of the points.
/// @param deviation  standard deviation, in the unit of the points
void add_point_noise(OrientedPointsd* points, double deviation, RandomStream& random);

/// Turns each normal by Gaussian noise.
/// @param deviation  standard deviation of each of the two components across the normal, before it
/// is scaled to unit length [-]
void add_normal_noise(OrientedPointsd* points, double deviation, RandomStream& random);

/// Replaces the normals by those of least-squares planes through the nearest points (Hoppe et al.
/// 1992), oriented like the old ones.
/// @param neighbours  number of points to which a plane is fitted
void estimate_normals(OrientedPointsd* points, int neighbours);

/// Returns the longest side of the bounding box.
double size_of(const Eigen::Matrix3Xd& points);

}  // namespace quadrille::experiments
