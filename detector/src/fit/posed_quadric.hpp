#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// A quadric given by its canonical matrix D and its pose X: Q = X⁻ᵀ D X⁻¹.
struct PosedQuadric {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  Eigen::Matrix4d D = Eigen::Matrix4d::Zero();
  Eigen::Matrix4d matrix() const;
};

/// A pose at the given position whose z axis has the given direction.
Eigen::Isometry3d pose_along(const Eigen::Vector3d& position, const Eigen::Vector3d& z);

/// The matrix of a fitted quadric in its canonical frame. Entries that the form requires to be zero
/// are zero up to rounding.
CanonicalForm canonical_form(const PosedQuadric& fit);

}  // namespace quadrille
