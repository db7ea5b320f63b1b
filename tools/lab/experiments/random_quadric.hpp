#pragma once

#include "base/random.hpp"
#include "fits/normalise.hpp"
#include "quadrille/detector/canonical.hpp"

namespace quadrille::experiments {

/// The curved types that experiments draw from, by index; the commoner first.
QuadricType curved_type(int index);
inline constexpr int kCurvedTypes = 12;

/// Standard normal (Box and Muller).
double gaussian(RandomStream& random);

/// A unit vector, uniform over the sphere.
Eigen::Vector3d random_direction(RandomStream& random);

/// A quadric of the type with random dimensions and orientation, about the origin, that fills the
/// unit ball or is cut by it.
Quadric random_quadric(QuadricType type, RandomStream& random);

/// Points of the quadric within the unit ball, uniform by area, with unit gradients as normals:
/// where isotropic random lines meet it (Cauchy and Crofton).
/// @throws std::invalid_argument if hardly a line meets the quadric
OrientedPointsd sample(const Quadric& Q, Eigen::Index count, RandomStream& random);

/// Adds Gaussian noise to each coordinate of the points.
/// @param deviation  in the unit of the points
void add_point_noise(OrientedPointsd* points, double deviation, RandomStream& random);

/// Turns each normal by Gaussian noise.
/// @param deviation  of each of the two components across the normal, before it is scaled [-]
void add_normal_noise(OrientedPointsd* points, double deviation, RandomStream& random);

/// Replaces the normals by those of least-squares planes through the nearest points (Hoppe et al.
/// 1992), on the side of the old ones.
/// @param neighbours  points that a plane is fitted to
void estimate_normals(OrientedPointsd* points, int neighbours);

/// Longest side of the bounding box.
double size_of(const Eigen::Matrix3Xd& points);

}  // namespace quadrille::experiments
