#include "boxes/outline.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille {

double Outline::turn(const Eigen::Vector3d& eye_C) const {
  const Eigen::Vector3d ahead_C = (face->middle_C - eye_C).normalized();
  return std::atan2(std::abs(face->n_C.dot(ahead_C)), std::max(0.0, out_C.dot(ahead_C)));
}

double Outline::hidden(double radius, const DirectionIndex& sight) const {
  if (!sight.single() || radius <= 0.0) return 0.0;
  const double depth = std::min(face->tolerance(), radius);
  const double shown =
      std::min(std::sqrt(depth * (2.0 * radius - depth)), radius * std::sin(turn(sight.eye())));
  return radius - shown;
}

}  // namespace quadrille
