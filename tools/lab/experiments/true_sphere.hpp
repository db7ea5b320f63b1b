#pragma once

#include <Eigen/Core>
#include <vector>

namespace quadrille::experiments {

/// A sphere with its centre in the frame of the points [m].
struct FittedSphere {
  Eigen::Vector3d centre;
  double radius = 0.0;
};

/// The sphere that minimises the sum of the squared distances of its surface from the points, by
/// Gauss and Newton from the algebraic fit; at least 4 points that are not in one plane.
FittedSphere fit_sphere(const std::vector<Eigen::Vector3d>& points);

}  // namespace quadrille::experiments
