#pragma once

#include <Eigen/Core>

#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"

namespace quadrille {

/// Moves points along their lines of sight onto a face's plane. If the line of sight is too oblique
/// to the plane (kMinCosine), or the cloud is not a single view, a point is moved at right angles
/// to the plane.
class OntoPlane {
 public:
  OntoPlane(const Face& face, const DirectionIndex& sight)
      : n_C_(face.n_C),
        offset_(face.offset),
        eye_C_(sight.eye()),
        eye_height_(face.height(eye_C_)),
        single_(sight.single()) {}

  Eigen::Vector3d operator()(const Eigen::Vector3d& p_C) const {
    if (single_) {
      const Eigen::Vector3d ray = p_C - eye_C_;
      const double fall = n_C_.dot(ray);
      if (fall * fall > kMinCosine * kMinCosine * ray.squaredNorm()) {
        return eye_C_ - ray * (eye_height_ / fall);
      }
    }
    return p_C - (n_C_.dot(p_C) - offset_) * n_C_;
  }

 private:
  Eigen::Vector3d n_C_;
  double offset_;
  Eigen::Vector3d eye_C_;
  double eye_height_;
  bool single_;
};

}  // namespace quadrille
