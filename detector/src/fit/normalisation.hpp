#pragma once

#include <Eigen/Core>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// Similarity that carries a region's points to about the unit ball: x_local = (x − centre) /
/// scale.
struct Normalisation {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double scale = 1.0;

  /// The quadric of local coordinates in the frame of the samples.
  Quadric to_frame(const Eigen::Matrix4d& Q_local) const;
  /// The inverse.
  Eigen::Matrix4d to_local(const Quadric& Q) const;
};

}  // namespace quadrille
