#pragma once

#include <Eigen/Geometry>

#include "lab/physics/true_body.hpp"

namespace quadrille::physics {

/// How far a point lies outside of a hollow body's wall and floors, negative within, and the unit
/// direction out of them.
struct WallDistance {
  double distance = 0.0;
  Eigen::Vector3d normal_S = Eigen::Vector3d::UnitZ();
};

/// To first order across the wall (f/|∇f| from the surface), exact past its rims and floors: a
/// smooth surface with smooth normals, as no set of flat pieces has.
WallDistance wall_distance(const TrueBody& body, const Eigen::Vector3d& p_S);

}  // namespace quadrille::physics
