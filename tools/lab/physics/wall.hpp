#pragma once

#include <Eigen/Geometry>

#include "lab/physics/true_body.hpp"

namespace quadrille::physics {

/// Distance by which a point lies outside the wall and floors of a hollow body, negative inside,
/// and the unit direction out of them.
struct WallDistance {
  double distance = 0.0;
  Eigen::Vector3d normal_S = Eigen::Vector3d::UnitZ();
};

/// Computes the distance to first order across the wall (f/|∇f| from the surface), and exactly
/// beyond its rims and floors. The surface and its normals are smooth, which those of flat pieces
/// are not.
WallDistance wall_distance(const TrueBody& body, const Eigen::Vector3d& p_S);

}  // namespace quadrille::physics
