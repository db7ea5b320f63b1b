#pragma once

#include <cmath>

#include "boxes/outline.hpp"

namespace quadrille::test {

/// How far a rounded edge seems to reach beyond the beginning of its rounding, by walking along its
/// arc: as long as it is within the face's tolerance and its normal is turned to the eye.
inline double shown_by_walking(const Outline& outline, double radius) {
  const Face& face = *outline.face;
  const Eigen::Vector3d to_eye_C = -face.middle_C.normalized();
  double shown = 0.0;
  for (double angle = 0.0; angle < 0.5 * M_PI; angle += 1e-4) {
    const Eigen::Vector3d n_C = std::cos(angle) * face.n_C + std::sin(angle) * outline.out_C;
    const double depth = radius * (1.0 - std::cos(angle));
    if (depth > face.tolerance() || n_C.dot(to_eye_C) < 0.0) break;
    shown = radius * std::sin(angle);
  }
  return shown;
}

}  // namespace quadrille::test
