#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "quadrille/detector/canonical.hpp"

namespace quadrille {

/// A quadric as a canonical matrix D in a pose X: Q = X⁻ᵀ D X⁻¹.
struct PosedQuadric {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  Eigen::Matrix4d D = Eigen::Matrix4d::Zero();
  Eigen::Matrix4d matrix() const;
};

/// The pose at a position with its z axis along a direction.
Eigen::Isometry3d pose_along(const Eigen::Vector3d& position, const Eigen::Vector3d& z);

/// The canonical form of a fit, whose zeros are exact but for rounding.
CanonicalForm canonical_form(const PosedQuadric& fit);

}  // namespace quadrille
